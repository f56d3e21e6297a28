#include "curve/pole_boxes.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::curve {

PoleBoxes::PoleBoxes(const std::vector<Nurbs>& curves) {
  for (const Nurbs& curve : curves) {
    Box box{curve.poles.front(), curve.poles.front()};
    for (const Vec2 pole : curve.poles) {
      box.low = {std::min(box.low.x, pole.x), std::min(box.low.y, pole.y)};
      box.high = {std::max(box.high.x, pole.x), std::max(box.high.y, pole.y)};
    }
    boxes_.push_back(box);
  }
}

double PoleBoxes::distance_bound(int curve, Vec2 x) const {
  const Box& box = boxes_[curve];
  return std::hypot(std::max({box.low.x - x.x, x.x - box.high.x, 0.0}),
                    std::max({box.low.y - x.y, x.y - box.high.y, 0.0}));
}

}  // namespace quadrille::curve
