#pragma once
// A curved face in its chart, as cad2chart writes it (formats/chart.md, x.chart.h5). cad2tri reads it in place of a CAD
// file; every later stage carries `face.chart` along.

#include "model/cad_face.hpp"
#include "model/provenance.hpp"

namespace quadrille {

struct ChartedFace {
  Provenance provenance;
  CadFace face;  ///< in the plane of the chart; `face.chart` is not null
};

}  // namespace quadrille
