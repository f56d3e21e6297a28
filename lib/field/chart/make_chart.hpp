#pragma once
// The isothermal chart of a curved face: a plane image that keeps angles, with the same arc lengths on the outline
// (lib/method.md §12).

#include "base/angle.hpp"
#include "base/report.hpp"
#include "model/cad_face.hpp"
#include "model/space_face.hpp"

namespace quadrille::chart {

struct ChartOptions {
  double closedness = 1e-6;          ///< goal for Chart::closedness (0, 1e-3]
  double worst_closedness = 1e-3;    ///< what is accepted if finer triangles do not help: surfaces that are not smooth
  double corner_angle = radians(1);  ///< jump of the tangent beyond which a joint is a corner, radians [0, pi/2]
  double greatest_scale_range = 1000;  ///< greatest ratio of two scales of the chart, above 1
  void validate() const;               ///< throws UsageError
};

/// The face in the plane of its chart, with face.chart: curves, joints, origin and diameter are those of the chart, and
/// curve i has the parameters of chart->space_curves[i]. A face in a plane is its own chart, with its exact curves.
/// Throws ComputeError, with place and remedy, if the chart overlaps itself, if its scales differ by more than the
/// option says, or if it stays less accurate than worst_closedness (a surface with a kink inside). Whether the goal was
/// missed is in chart->closedness and in the report.
CadFace make_chart(const SpaceFace& space_face, const ChartOptions& options, Report& report);

}  // namespace quadrille::chart
