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

double PoleBox::distance_from(Vec2 x) const {
  return norm({std::max({low.x - x.x, x.x - high.x, 0.0}), std::max({low.y - x.y, x.y - high.y, 0.0})});
}

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

std::vector<PoleBox> pole_boxes(const std::vector<Nurbs>& curves) {
  std::vector<PoleBox> boxes;
  for (const Nurbs& curve : curves) boxes.push_back(pole_box(curve));
  return boxes;
}

}  // namespace quadrille::curve
