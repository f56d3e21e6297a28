#pragma once
// Smooth curves as cubic Bezier segments: Hermite interpolation, halved until it is exact to a fraction of a pixel.

#include <functional>

#include "draw/svg.hpp"

namespace quadrille::draw {

struct CurvePoint {
  Vec2 position;    ///< pixels
  Vec2 derivative;  ///< with respect to the parameter
};
using PixelCurve = std::function<CurvePoint(double)>;

/// Appends the curve from t0 to t1 (t0 > t1: backwards) to `path`, whose last point is its start. Straight parts become
/// lines. The distance to the curve is below 0.05 pixels at the sampled points.
void append_curve(PathData& path, const PixelCurve& curve, double t0, double t1);

}  // namespace quadrille::draw
