#pragma once
// Nearest points of curves in space, and the diameter of a curved face.

#include "model/chart.hpp"

namespace quadrille::surface {

struct CurveProjection {
  double t = 0;
  Vec3 position;
  double distance = 0;
};

/// The point of the curve nearest to x: samples each knot span, then Newton's method around the nearest samples.
CurveProjection project(const SpaceCurve& curve, Vec3 x);

/// The largest distance in space between two nodes of the chart: from the node that is farthest from the mean, always
/// to the node that is farthest from the last one, until that is the one before. Cost: linear.
double diameter(const Chart& chart);

}  // namespace quadrille::surface
