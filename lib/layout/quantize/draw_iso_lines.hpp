#pragma once
// The iso-lines of a face as splines: images of straight lines of the unit square under the face's transfinite map
// (mesh/transfinite.hpp), so that lines of one direction never cross.

#include "curve/chain.hpp"
#include "graph/candidate_layout.hpp"
#include "quantize/split_arcs.hpp"

namespace quadrille::quantize {

/// A T-mesh with the iso-lines of its parametrization; `table`: of its curves, `parts`: of its arcs.
struct ParametrizedTMesh {
  const ArcGraph& graph;
  const curve::CurveTable& table;
  const QuantizedParametrization& parametrization;
  const ArcParts& parts;
};

/// Divides a face of the T-mesh by its iso-lines: adds a spline and arcs for each, a node where two of them cross, and
/// lines of kind LineKind::extended. `layout`: of the T-mesh, with split arcs.
void draw_iso_lines(const ParametrizedTMesh& t_mesh, int face, graph::CandidateLayout& layout);

}  // namespace quadrille::quantize
