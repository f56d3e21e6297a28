#pragma once
// Curves inside a curved face, in its chart.

#include <vector>

#include "model/cad_face.hpp"
#include "model/space_face.hpp"

namespace quadrille::chart {

/// A curve in space and its image in the chart, with the same parameters.
struct ImagedCurve {
  SpaceCurve space;
  Nurbs image;
};

/// The inner curves of `space_face` in the chart of `face`, which make_chart made of it. Closed curves with rough
/// parameters become splines as in with_smooth_parameters. A face in a plane has the exact curves.
std::vector<ImagedCurve> inner_curves_in_chart(const SpaceFace& space_face, const CadFace& face);

}  // namespace quadrille::chart
