#include "curve/pole_box.hpp"

#include <algorithm>

namespace quadrille::curve {
namespace {

void extend(PoleBox& box, const std::vector<Vec2>& points) {
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
}

}  // namespace

PoleBox pole_box(const Nurbs& curve) {
  PoleBox box{curve.poles.front(), curve.poles.front()};
  extend(box, curve.poles);
  return box;
}

PoleBox pole_box(const std::vector<Nurbs>& curves) {
  PoleBox box = pole_box(curves.front());
  for (const Nurbs& curve : curves) extend(box, curve.poles);
  return box;
}

}  // namespace quadrille::curve
