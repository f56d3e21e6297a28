#pragma once
// The scale of a chart, for prescribed sizes: these are lengths in space, e^lambda times those in the chart.

#include <memory>
#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"

namespace quadrille::sizing {

/// lambda by cubic interpolation on a grid over the chart, continued beyond the boundary: to about 1e-4.
class ChartScale {
 public:
  explicit ChartScale(const CadFace& face);

  /// Length in space over length in the chart.
  double at(Vec2 x) const;
  double least() const { return least_; }
  double greatest_gradient() const { return gradient_; }  ///< of lambda, 1 over a length of the chart

 private:
  struct Grid {
    Vec2 lower;
    double step = 1;
    int nx = 0, ny = 0;
  };
  double log_at(int i, int j) const { return values_[j * grid_.nx + i]; }

  Grid grid_;
  std::vector<double> values_;  ///< lambda, x fastest
  double least_ = 1, gradient_ = 0;
};

/// The length of a boundary curve, of a curved face in space.
double boundary_length(const CadFace& face, int curve);

/// Null for planar faces.
std::shared_ptr<const ChartScale> chart_scale(const CadFace& face);

}  // namespace quadrille::sizing
