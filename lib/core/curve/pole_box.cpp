#include "curve/pole_box.hpp"

#include <algorithm>

namespace quadrille::curve {

void PoleBox::extend(const PoleBox& other) {
  low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
  high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
}

double PoleBox::distance_from(Vec2 x) const {
  return norm({std::max({low.x - x.x, x.x - high.x, 0.0}), std::max({low.y - x.y, x.y - high.y, 0.0})});
}

PoleBox pole_box(const Nurbs& curve) {
  PoleBox box{curve.poles.front(), curve.poles.front()};
  for (const Vec2 p : curve.poles) box.extend({p, p});
  return box;
}

PoleBox pole_box(const std::vector<Nurbs>& curves) {
  PoleBox box = pole_box(curves.front());
  for (const Nurbs& curve : curves) box.extend(pole_box(curve));
  return box;
}

std::vector<PoleBox> pole_boxes(const std::vector<Nurbs>& curves) {
  std::vector<PoleBox> boxes;
  for (const Nurbs& curve : curves) boxes.push_back(pole_box(curve));
  return boxes;
}

}  // namespace quadrille::curve
