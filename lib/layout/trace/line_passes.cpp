#include "trace/line_passes.hpp"

#include <algorithm>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"

namespace quadrille::trace {
namespace {

constexpr size_t samples_per_box = 16;  // consecutive samples for which near nodes are searched together
constexpr double round_off = 1e-9;

}  // namespace

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
    const double most = reach(i, slope, max_distance);
    if (here > most * most) continue;
    if (i == last && !ends_beside(node)) continue;
    found.push_back({s_[i - 1], i < last ? s_[i + 1] : s_[i], -1});
  }
  return found;
}

double LinePasses::reach(size_t i, double slope, double max_distance) const {
  const double spacing = s_[i] - s_[i - 1] + (i + 1 < s_.size() ? s_[i + 1] - s_[i] : 0.0);
  return std::max(slope * s_[i], max_distance) + spacing;
}

std::vector<int> LinePasses::nodes_near(const PointGrid& nodes, double slope, double max_distance) const {
  std::vector<int> near;
  for (size_t first = 1; first < s_.size(); first += samples_per_box) {
    const size_t last = std::min(first + samples_per_box, s_.size()) - 1;
    Vec2 low = x_[first], high = x_[first];
    double margin = 0;
    for (size_t i = first; i <= last; ++i) {
      low = {std::min(low.x, x_[i].x), std::min(low.y, x_[i].y)};
      high = {std::max(high.x, x_[i].x), std::max(high.y, x_[i].y)};
      margin = std::max(margin, (1 + round_off) * reach(i, slope, max_distance));
    }
    nodes.visit_box(low - Vec2{margin, margin}, high + Vec2{margin, margin}, [&](int n) { near.push_back(n); });
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
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
