#include "trace/streamline.hpp"

#include <algorithm>
#include <cstddef>

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

void Streamline::index_steps() {
  for (std::size_t i = step_starts_.size(); i < steps.size(); ++i) step_starts_.push_back(steps[i].s);
}

// The last step that begins at s or before, or the first one.
const StreamStep& Streamline::step_at(double s) const {
  if (step_starts_.size() == steps.size()) {
    const auto after = std::upper_bound(step_starts_.begin(), step_starts_.end(), s);
    return steps[std::max<std::ptrdiff_t>(after - step_starts_.begin(), 1) - 1];
  }
  const auto after =
      std::upper_bound(steps.begin(), steps.end(), s, [](double v, const StreamStep& k) { return v < k.s; });
  return after == steps.begin() ? steps.front() : *(after - 1);
}

Vec2 Streamline::at(const field::FieldEvaluator& evaluator, double s, Vec2& direction) const {
  if (s <= launch.radius || steps.empty()) return lead_in(std::max(s, 0.0), direction);
  if (s >= length()) {
    direction = unit(end_angle);
    return end_position;
  }
  const StreamStep& step = step_at(s);
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
