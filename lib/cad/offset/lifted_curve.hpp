#pragma once
// A curve of a chart on the surface.

#include "mesh/chart_map.hpp"
#include "model/cad_face.hpp"

namespace quadrille::offset {

/// The curve in space with the parameters of `image`, a curve inside the chart of `face`, on the surface to 1e-12
/// diameters where that has enough derivatives. Along the surface it is as near to the lifted points as curves of the
/// boundary are to theirs. Ends on the boundary of the chart are there in space.
SpaceCurve lifted_curve(const mesh::ChartMap& map, const CadFace& face, const Nurbs& image);

}  // namespace quadrille::offset
