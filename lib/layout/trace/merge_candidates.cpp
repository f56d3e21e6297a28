#include "trace/merge_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "graph/crossings.hpp"

namespace quadrille::trace {
namespace {

constexpr int num_samples = 48;

// Both lines and their blend at one fraction of the lengths.
struct Blend {
  Vec2 position, derivative;  // of M, with respect to f
  Vec2 along_a, along_b;      // unit directions of both lines, each its own
};

Blend blend(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
            const MergeCandidate& candidate, double f) {
  const double c = std::cos(half_pi * f), w = c * c, slope = -half_pi * std::sin(pi * f);
  const double length_a = candidate.length_a, length_b = candidate.length_b;
  Blend m;
  const Vec2 xa = a.at(evaluator, f * length_a, m.along_a), xb = b.at(evaluator, (1 - f) * length_b, m.along_b);
  m.position = w * xa + (1 - w) * xb;
  m.derivative = w * length_a * m.along_a - (1 - w) * length_b * m.along_b + slope * (xa - xb);
  return m;
}

// The joined line at fraction f of its length: position, and derivative with respect to f.
Vec2 joined(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b, double length, double f,
            Vec2& derivative) {
  Vec2 along, along_end;
  const Vec2 x = a.at(evaluator, f * length, along), end = a.at(evaluator, length, along_end);
  const Vec2 shift = b.launch.origin - end, bend = -length * (unit(b.launch.angle) + along_end);
  derivative = length * along + 6 * f * (1 - f) * shift + f * (3 * f - 2) * bend;
  return x + f * f * ((3 - 2 * f) * shift - (1 - f) * bend);
}

// Consecutive samples lie far from each other: the first one that deviates too far ends the loop.
bool blend_deviates_at_most(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                            double max_deviation, MergeCandidate& candidate) {
  constexpr int stride = 19;  // no divisor in common with num_samples
  for (int i = stride; i != 0; i = (i + stride) % num_samples) {
    const double f = static_cast<double>(i) / num_samples, w = std::pow(std::cos(half_pi * f), 2);
    const Blend m = blend(evaluator, a, b, candidate, f);
    const double angle = graph::angle_between(m.derivative, w * m.along_a - (1 - w) * m.along_b);
    candidate.deviation = std::max(candidate.deviation, angle);
    if (candidate.deviation > max_deviation) return false;
  }
  return true;
}

bool join_deviates_at_most(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                           double max_deviation, MergeCandidate& candidate) {
  double guide = a.launch.angle;
  for (int i = 1; i < num_samples; ++i) {
    Vec2 derivative, value;
    const double f = static_cast<double>(i) / num_samples;
    if (!evaluator.value_at(joined(evaluator, a, b, candidate.length_a, f, derivative), value)) return false;
    guide = guided_angle(value, guide);
    candidate.deviation = std::max(candidate.deviation, graph::angle_between(derivative, unit(guide)));
    if (candidate.deviation > max_deviation) return false;
  }
  return true;
}

bool are_unequal(double a, double b) { return std::abs(a - b) > merge_limits.inequality * (a + b) / 2; }

// Whether are_unequal holds for all lengths within two passes.
bool are_unequal(const LinePass& a, const LinePass& b) {
  const double gap = std::max(a.low - b.high, b.low - a.high);
  return gap > merge_limits.inequality * (a.high + b.high) / 2;
}

/// The passes of one line near one node.
struct NodePasses {
  int node = 0;
  std::vector<LinePass> passes;
};

class CandidateSearch {
 public:
  CandidateSearch(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
                  const std::vector<Vec2>& nodes, const MergeOptions& options)
      : evaluator_(evaluator), lines_(lines), nodes_(nodes), options_(options), lines_of_(nodes.size()) {
    // The blend's slope adds at most (pi / 2) gap / length to the direction.
    const double slope = 2 * std::tan(options.max_angle);
    const PointGrid grid(nodes);
    along_.reserve(lines.size());
    for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
      if (lines[i].launch.start.node >= 0) lines_of_[lines[i].launch.start.node].push_back(i);
      along_.emplace_back(evaluator, lines[i]);
      passes_.emplace_back();
      for (const int node : along_.back().nodes_near(grid, slope, 4 * options.distance)) {
        std::vector<LinePass> passes = along_.back().passes_of(nodes[node], slope, 4 * options.distance);
        if (!passes.empty()) passes_.back().push_back({node, std::move(passes)});
      }
    }
  }

  std::vector<MergeCandidate> run() {
    const int num_lines = static_cast<int>(lines_.size());
    for (int i = 0; i < num_lines; ++i)
      for (const int j : partners_after(i))
        if (may_merge(i, j)) add_pairs(i, j);
    for (const MergeCandidate& pair : candidates_) pairs_.insert({pair.a, pair.b});
    if (!options_.only_endless)
      for (int i = 0; i < num_lines; ++i)
        if (lines_[i].launch.start.node >= 0)
          for (NodePasses& passed : passes_[i]) add_joins(i, passed);
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const MergeCandidate& x, const MergeCandidate& y) {
      return x.delayed_meeting() < y.delayed_meeting();
    });
    return std::move(candidates_);
  }

 private:
  // The lines after line i that start at nodes which it passes, ascending.
  std::vector<int> partners_after(int i) const {
    std::vector<int> partners;
    for (const NodePasses& passed : passes_[i])
      for (const int j : lines_of_[passed.node])
        if (j > i) partners.push_back(j);
    std::sort(partners.begin(), partners.end());
    return partners;
  }

  bool may_merge(int i, int j) const {
    if (lines_[i].launch.start.node < 0 || lines_[j].launch.start.node < 0) return false;
    return !options_.only_endless || lines_[i].is_endless() || lines_[j].is_endless();
  }

  // Empty if the line does not pass the node.
  std::span<LinePass> passes_at(int line, int node) {
    std::vector<NodePasses>& all = passes_[line];
    const auto at =
        std::lower_bound(all.begin(), all.end(), node, [](const NodePasses& passed, int n) { return passed.node < n; });
    return at != all.end() && at->node == node ? std::span<LinePass>(at->passes) : std::span<LinePass>();
  }

  void add_pairs(int i, int j) {
    const int from_i = lines_[i].launch.start.node, from_j = lines_[j].launch.start.node;
    const std::span<LinePass> passes_j = passes_at(j, from_i);
    for (LinePass& pass_i : passes_at(i, from_j))
      for (LinePass& pass_j : passes_j) {
        if (are_unequal(pass_i, pass_j)) continue;
        MergeCandidate pair{i, j, along_[i].foot(nodes_[from_j], pass_i), along_[j].foot(nodes_[from_i], pass_j)};
        if (are_unequal(pair.length_a, pair.length_b)) continue;
        if (meeting_angle(i, pair.length_a, j) > merge_limits.head_on_angle) continue;
        if (meeting_angle(j, pair.length_b, i) > merge_limits.head_on_angle) continue;
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
    const double most =
        is_aggressive ? std::max(options_.max_angle, merge_limits.aggressive_angle) : options_.max_angle;
    return deviates_at_most(evaluator_, a, b, most, pair);
  }

  // Adds the joins of a line that passes a node within the distance or ends in it.
  void add_joins(int line, NodePasses& passed) {
    const int node = passed.node;
    if (lines_[line].launch.start.node == node) return;
    if (options_.distance == 0 && lines_[line].reached.node != node) return;
    for (LinePass& pass : passed.passes) {
      const double length = along_[line].foot(nodes_[node], pass);
      const double gap = distance(lines_[line].at(evaluator_, length), nodes_[node]);
      const int other = gap <= options_.distance ? line_against(line, length, node) : -1;
      if (other < 0 || is_pair(line, other)) continue;
      MergeCandidate join{line, other, length, length, 0, gap, true};
      if (deviates_at_most(evaluator_, lines_[line], lines_[other], merge_limits.aggressive_angle, join))
        candidates_.push_back(join);
    }
  }

  // A join of two lines that are a pair is not needed.
  bool is_pair(int i, int j) const { return pairs_.contains(std::minmax(i, j)); }

  // The line of a node whose direction is most nearly opposite to a line that passes there; -1: there is none.
  int line_against(int passing, double length, int node) const {
    int best = -1;
    double least = merge_limits.head_on_angle;
    for (const int j : lines_of_[node]) {
      const double angle = meeting_angle(passing, length, j);
      if (angle < least) least = angle, best = j;
    }
    return best;
  }

  // Angle between line a, where it passes the start of line b, and the opposite of b's direction.
  double meeting_angle(int a, double length, int b) const {
    Vec2 direction;
    lines_[a].at(evaluator_, length, direction);
    return graph::angle_between(direction, -unit(lines_[b].launch.angle));
  }

  const field::FieldEvaluator& evaluator_;
  const std::vector<Streamline>& lines_;
  const std::vector<Vec2>& nodes_;
  const MergeOptions& options_;
  std::vector<std::vector<int>> lines_of_;  // that start at each node
  std::vector<LinePasses> along_;
  std::vector<std::vector<NodePasses>> passes_;  // of each line, by ascending node
  std::vector<MergeCandidate> candidates_;
  std::set<std::pair<int, int>> pairs_;  // of lines, the lower one first
};

}  // namespace

curve::CurveFunction merged_curve(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                                  const MergeCandidate& candidate) {
  return [&evaluator, &a, &b, candidate, length = candidate.length()](double s, Vec2& derivative) {
    const double f = std::clamp(s / length, 0.0, 1.0);
    Vec2 x;
    if (candidate.is_join) {
      x = joined(evaluator, a, b, length, f, derivative);
    } else {
      const Blend m = blend(evaluator, a, b, candidate, f);
      x = m.position, derivative = m.derivative;
    }
    derivative = derivative / length;
    return f == 0 ? a.launch.origin : f == 1 ? b.launch.origin : x;
  };
}

bool deviates_at_most(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                      double max_deviation, MergeCandidate& candidate) {
  candidate.deviation = 0;
  return candidate.is_join ? join_deviates_at_most(evaluator, a, b, max_deviation, candidate)
                           : blend_deviates_at_most(evaluator, a, b, max_deviation, candidate);
}

std::vector<MergeCandidate> merge_candidates(const field::FieldEvaluator& evaluator,
                                             const std::vector<Streamline>& lines, const std::vector<Vec2>& nodes,
                                             const MergeOptions& options) {
  return CandidateSearch(evaluator, lines, nodes, options).run();
}

}  // namespace quadrille::trace
