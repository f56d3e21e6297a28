#include "trace/merge_candidates.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "trace/line_passes.hpp"

namespace quadrille::trace {
namespace {

// Largest angle between a line that passes a node and the line that starts there towards it. Lines turn by about 45
// degrees as they pass a node: the deviation of the merged line decides.
constexpr double head_on_angle = radians(75);
constexpr double max_inequality = 0.3;  // of the two lengths, relative to their mean: fronts of such a pair never meet

bool are_unequal(double a, double b) { return std::abs(a - b) > max_inequality * (a + b) / 2; }

// Whether are_unequal holds for all lengths within two passes.
bool are_unequal(const LinePass& a, const LinePass& b) {
  const double gap = std::max(a.low - b.high, b.low - a.high);
  return gap > max_inequality * (a.high + b.high) / 2;
}

class CandidateSearch {
 public:
  CandidateSearch(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
                  const std::vector<Vec2>& nodes, const MergeOptions& options)
      : evaluator_(evaluator), lines_(lines), nodes_(nodes), options_(options) {
    // The blend's slope adds at most (pi / 2) gap / length to the direction.
    const double slope = 2 * std::tan(options.max_angle);
    along_.reserve(lines.size());
    for (const Streamline& line : lines) {
      along_.emplace_back(evaluator, line);
      passes_.emplace_back();
      for (const Vec2 node : nodes)
        passes_.back().push_back(along_.back().passes_of(node, slope, 4 * options.distance));
    }
  }

  std::vector<MergeCandidate> run() {
    const int num_lines = static_cast<int>(lines_.size());
    for (int i = 0; i < num_lines; ++i)
      for (int j = i + 1; j < num_lines; ++j)
        if (may_merge(i, j)) add_pairs(i, j);
    const size_t num_pairs = candidates_.size();
    if (!options_.only_endless)
      for (int i = 0; i < num_lines; ++i)
        if (lines_[i].launch.start.node >= 0)
          for (int node = 0; node < static_cast<int>(nodes_.size()); ++node) add_joins(i, node, num_pairs);
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const MergeCandidate& x, const MergeCandidate& y) {
      return x.delayed_meeting() < y.delayed_meeting();
    });
    return std::move(candidates_);
  }

 private:
  bool may_merge(int i, int j) const {
    if (lines_[i].launch.start.node < 0 || lines_[j].launch.start.node < 0) return false;
    return !options_.only_endless || lines_[i].is_endless() || lines_[j].is_endless();
  }

  void add_pairs(int i, int j) {
    const int from_i = lines_[i].launch.start.node, from_j = lines_[j].launch.start.node;
    for (LinePass& pass_i : passes_[i][from_j])
      for (LinePass& pass_j : passes_[j][from_i]) {
        if (are_unequal(pass_i, pass_j)) continue;
        MergeCandidate pair{i, j, along_[i].foot(nodes_[from_j], pass_i), along_[j].foot(nodes_[from_i], pass_j)};
        if (are_unequal(pair.length_a, pair.length_b)) continue;
        if (meeting_angle(i, pair.length_a, j) > head_on_angle) continue;
        if (meeting_angle(j, pair.length_b, i) > head_on_angle) continue;
        if (is_allowed(pair)) candidates_.push_back(pair);
      }
  }

  // Whether the normal or the aggressive rule allows the pair. Computes gap and deviation.
  bool is_allowed(MergeCandidate& pair) const {
    const Streamline &a = lines_[pair.a], &b = lines_[pair.b];
    const double la = pair.length_a, lb = pair.length_b;
    const double at_nodes =
        std::max(distance(a.at(evaluator_, la), b.launch.origin), distance(b.at(evaluator_, lb), a.launch.origin));
    pair.gap = std::min(at_nodes, distance(a.at(evaluator_, la / 2), b.at(evaluator_, lb / 2)));
    if (pair.gap > std::max(options_.distance, std::tan(options_.max_angle) * pair.length())) return false;
    const bool is_aggressive = pair.gap <= options_.distance;
    const double most = is_aggressive ? std::max(options_.max_angle, max_aggressive_angle) : options_.max_angle;
    return deviates_at_most(evaluator_, a, b, most, pair);
  }

  // Adds the joins of a line that passes a node within the distance or ends in it. The first `num_pairs` candidates are
  // pairs: a join of the same two lines is not needed.
  void add_joins(int line, int node, size_t num_pairs) {
    if (lines_[line].launch.start.node == node) return;
    if (options_.distance == 0 && lines_[line].reached.node != node) return;
    for (LinePass& pass : passes_[line][node]) {
      const double length = along_[line].foot(nodes_[node], pass);
      const double gap = distance(lines_[line].at(evaluator_, length), nodes_[node]);
      const int other = gap <= options_.distance ? line_against(line, length, node) : -1;
      if (other < 0 || is_pair(line, other, num_pairs)) continue;
      MergeCandidate join{line, other, length, length, 0, gap, true};
      if (deviates_at_most(evaluator_, lines_[line], lines_[other], max_aggressive_angle, join))
        candidates_.push_back(join);
    }
  }

  bool is_pair(int i, int j, size_t num_pairs) const {
    return std::any_of(candidates_.begin(), candidates_.begin() + num_pairs,
                       [&](const MergeCandidate& c) { return (c.a == i && c.b == j) || (c.a == j && c.b == i); });
  }

  // The line of a node whose direction is most nearly opposite to a line that passes there; -1: there is none.
  int line_against(int passing, double length, int node) const {
    int best = -1;
    double least = head_on_angle;
    for (int j = 0; j < static_cast<int>(lines_.size()); ++j) {
      if (lines_[j].launch.start.node != node) continue;
      const double angle = meeting_angle(passing, length, j);
      if (angle < least) least = angle, best = j;
    }
    return best;
  }

  // Angle between line a, where it passes the start of line b, and the opposite of b's direction.
  double meeting_angle(int a, double length, int b) const {
    Vec2 direction;
    lines_[a].at(evaluator_, length, direction);
    return angle_between(direction, -unit(lines_[b].launch.angle));
  }

  const field::FieldEvaluator& evaluator_;
  const std::vector<Streamline>& lines_;
  const std::vector<Vec2>& nodes_;
  const MergeOptions& options_;
  std::vector<LinePasses> along_;
  std::vector<std::vector<std::vector<LinePass>>> passes_;  // [line][node]
  std::vector<MergeCandidate> candidates_;
};

}  // namespace

std::vector<MergeCandidate> merge_candidates(const field::FieldEvaluator& evaluator,
                                             const std::vector<Streamline>& lines, const std::vector<Vec2>& nodes,
                                             const MergeOptions& options) {
  return CandidateSearch(evaluator, lines, nodes, options).run();
}

}  // namespace quadrille::trace
