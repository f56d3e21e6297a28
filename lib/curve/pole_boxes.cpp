#include "curve/pole_boxes.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::curve {

PoleBox::PoleBox(const Nurbs& curve) : low(curve.poles.front()), high(low) {
  for (const Vec2 pole : curve.poles) {
    low = {std::min(low.x, pole.x), std::min(low.y, pole.y)};
    high = {std::max(high.x, pole.x), std::max(high.y, pole.y)};
  }
}

double PoleBox::distance_bound(Vec2 x) const {
  return std::hypot(std::max({low.x - x.x, x.x - high.x, 0.0}), std::max({low.y - x.y, x.y - high.y, 0.0}));
}

}  // namespace quadrille::curve
