#pragma once
// The nearest point of a NURBS curve.

#include "model/cad_face.hpp"

namespace quadrille::curve {

struct Projection {
  double t = 0;
  Vec2 position;
  double distance = 0;
};

/// The point of `curve` on [t0, t1] nearest to `x`: samples each knot span, then Newton on the best few.
Projection project(const Nurbs& curve, Vec2 x, double t0, double t1);
Projection project(const Nurbs& curve, Vec2 x);

}  // namespace quadrille::curve
