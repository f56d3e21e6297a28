#include "page/page_frame.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::page {

std::int32_t PageFrame::quantised(double distance) const {
  constexpr double limit = 2147483647;
  const double steps = std::round(distance / step);
  return std::isnan(steps) ? 0 : static_cast<std::int32_t>(std::clamp(steps, -limit, limit));
}

void PageFrame::append(std::vector<std::int32_t>& to, Vec2 x) const {
  to.push_back(quantised(x.x - centre.x));
  to.push_back(quantised(x.y - centre.y));
}

PageFrame page_frame(const draw::PictureBox& box) {
  if (box.empty()) return page_frame({{0, 0}, {1, 1}});
  const double extent = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
  PageFrame frame;
  frame.centre = 0.5 * (box.lower + box.upper);
  frame.extent = extent > 0 ? extent : 1;
  frame.step = std::ldexp(frame.extent, -30);
  return frame;
}

}  // namespace quadrille::page
