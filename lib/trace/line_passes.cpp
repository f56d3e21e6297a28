#include "trace/line_passes.hpp"

#include <algorithm>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"

namespace quadrille::trace {

LinePasses::LinePasses(const field::FieldEvaluator& evaluator, const Streamline& line)
    : evaluator_(evaluator), line_(line) {
  const std::vector<double> ends = line.step_ends();
  for (size_t i = 0; i < ends.size(); ++i) {
    if (i > 0 && ends[i] > ends[i - 1]) s_.push_back((ends[i - 1] + ends[i]) / 2);
    if (s_.empty() || ends[i] > s_.back()) s_.push_back(ends[i]);
  }
  for (const double s : s_) x_.push_back(line.at(evaluator, s));
}

std::vector<LinePass> LinePasses::passes_of(Vec2 node, double slope, double max_distance) const {
  std::vector<LinePass> found;
  const size_t last = s_.size() - 1;
  double before = norm2(x_[0] - node), here = 0;
  for (size_t i = 1; i <= last; ++i, before = here) {
    here = norm2(x_[i] - node);
    if (here > before || (i < last && here >= norm2(x_[i + 1] - node))) continue;
    const double spacing = s_[i] - s_[i - 1] + (i < last ? s_[i + 1] - s_[i] : 0.0);
    const double reach = std::max(slope * s_[i], max_distance) + spacing;
    if (here > reach * reach) continue;
    if (i == last && !ends_beside(node)) continue;
    found.push_back({s_[i - 1], i < last ? s_[i + 1] : s_[i], -1});
  }
  return found;
}

// The root of (node - x) . x', which decreases as the line passes the node.
double LinePasses::foot(Vec2 node, LinePass& pass) const {
  if (pass.foot >= 0) return pass.foot;
  const auto ahead = [&](double s) {
    Vec2 direction;
    const Vec2 x = line_.at(evaluator_, s, direction);
    return dot(node - x, direction);
  };
  return pass.foot = falling_root(ahead, pass.low, pass.high, 1e-13, 1e-14);
}

bool LinePasses::ends_beside(Vec2 node) const {
  const Vec2 gap = node - line_.end_position;
  if (line_.end == Streamline::End::node) return line_.end_position == node;
  return line_.end == Streamline::End::boundary && dot(gap, unit(line_.end_angle)) <= 0.5 * norm(gap);
}

}  // namespace quadrille::trace
