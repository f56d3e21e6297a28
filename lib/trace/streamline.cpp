#include "trace/streamline.hpp"

#include <algorithm>

#include "base/angle.hpp"

namespace quadrille::trace {

// The cubic from the node to the first point, with the directions at both.
Vec2 Streamline::lead_in(double s, Vec2& direction) const {
  const double r = launch.radius, f = r > 0 ? s / r : 0;
  const Vec2 d0 = r * unit(launch.angle), d1 = r * unit(launch.angle_there), rise = launch.x - launch.origin;
  const Vec2 c2 = 3 * rise - 2 * d0 - d1, c3 = d0 + d1 - 2 * rise;
  direction = r > 0 ? normalized(d0 + 2 * f * c2 + 3 * f * f * c3) : unit(launch.angle);
  return launch.origin + f * (d0 + f * (c2 + f * c3));
}

Vec2 Streamline::at(const field::FieldEvaluator& evaluator, double s, Vec2& direction) const {
  if (s <= launch.radius || steps.empty()) return lead_in(std::max(s, 0.0), direction);
  if (s >= length()) {
    direction = unit(end_angle);
    return end_position;
  }
  const auto after =
      std::upper_bound(steps.begin(), steps.end(), s, [](double v, const StreamStep& k) { return v < k.s; });
  const StreamStep& step = after == steps.begin() ? steps.front() : *(after - 1);
  const double theta = std::clamp((s - step.s) / step.h, 0.0, 1.0);
  if (step.elem == in_the_plane) {
    direction = normalized(step.slope(theta));
    return step.xi(theta);
  }
  Vec2 x;
  Mat2 dx_dxi;
  evaluator.maps()[step.elem].evaluate(step.xi(theta), x, dx_dxi);
  direction = normalized(dx_dxi * step.slope(theta));
  return x;
}

Vec2 Streamline::at(const field::FieldEvaluator& evaluator, double s) const {
  Vec2 direction;
  return at(evaluator, s, direction);
}

std::vector<double> Streamline::step_ends() const {
  std::vector<double> ends{0};
  for (const StreamStep& step : steps) ends.push_back(step.s);
  ends.push_back(length());
  return ends;
}

}  // namespace quadrille::trace
