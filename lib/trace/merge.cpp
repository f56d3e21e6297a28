#include "trace/merge.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::trace {
namespace {

// Between a line where it passes a node and the line that leaves the node towards it. Lines turn where they pass a
// node, by about 45 degrees at their foot: what decides is the turn of the merged line.
constexpr double head_on_angle = radians(75);
constexpr double tie_share = 1e-6;  // lengths that differ by less are equal
constexpr int num_samples = 48;

double angle_between(Vec2 a, Vec2 b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); }

// A stretch of a line, between two arc lengths, on which it comes nearest to a point.
struct Pass {
  double low = 0, high = 0;
  double foot = -1;  // where that is; found when it is asked for
};

// Places where a line comes nearest to a point: local minima of the distance below a length that grows with s.
class Passes {
 public:
  Passes(const field::FieldEvaluator& evaluator, const Streamline& line) : evaluator_(evaluator), line_(line) {
    // Step ends and the middles between them follow the line closely enough to bracket every minimum.
    const std::vector<double> ends = line.step_ends();
    for (size_t i = 0; i < ends.size(); ++i) {
      if (i > 0 && ends[i] > ends[i - 1]) s_.push_back((ends[i - 1] + ends[i]) / 2);
      if (s_.empty() || ends[i] > s_.back()) s_.push_back(ends[i]);
    }
    for (const double s : s_) x_.push_back(line.at(evaluator, s));
  }

  std::vector<Pass> by(Vec2 node, double slope, double distance_allowed) const {
    std::vector<Pass> found;
    const size_t last = s_.size() - 1;
    double before = norm2(x_[0] - node), here = 0;
    for (size_t i = 1; i <= last; ++i, before = here) {
      here = norm2(x_[i] - node);
      if (here > before || (i < last && here >= norm2(x_[i + 1] - node))) continue;
      const double spacing = s_[i] - s_[i - 1] + (i < last ? s_[i + 1] - s_[i] : 0.0);
      const double reach = std::max(slope * s_[i], distance_allowed) + spacing;
      if (here > reach * reach) continue;
      if (i == last && !ends_beside(node)) continue;
      found.push_back({s_[i - 1], i < last ? s_[i + 1] : s_[i], -1});
    }
    return found;
  }

  double foot(Vec2 node, Pass& pass) const {
    if (pass.foot < 0) pass.foot = find_foot(node, pass.low, pass.high);
    return pass.foot;
  }

 private:
  // A line that ends before it has passed the node must end in it, or nearly abreast of it (a corner): else what lies
  // between may be a hole.
  bool ends_beside(Vec2 node) const {
    const Vec2 gap = node - line_.end_position;
    if (line_.end == Streamline::End::node) return line_.end_position == node;
    return line_.end == Streamline::End::boundary && dot(gap, unit(line_.end_angle)) <= 0.5 * norm(gap);
  }

  // Root of (node - x) . x' by false position (Illinois) between a and b.
  double find_foot(Vec2 node, double a, double b) const {
    const auto ahead = [&](double s) {
      Vec2 direction;
      const Vec2 x = line_.at(evaluator_, s, direction);
      return dot(node - x, direction);
    };
    double fa = ahead(a), fb = ahead(b);
    if (fb >= 0) return b;
    if (fa <= 0) return a;
    double m = b;
    for (int i = 0, side = 0; i < 50; ++i) {
      m = (a * fb - b * fa) / (fb - fa);
      const double f = ahead(m);
      if (std::abs(f) <= 1e-13 * b || b - a <= 1e-14 * b) break;
      (f > 0 ? a : b) = m;
      (f > 0 ? fa : fb) = f;
      const int now = f > 0 ? 1 : -1;
      if (now == side) (f > 0 ? fb : fa) /= 2;
      side = now;
    }
    return m;
  }

  const field::FieldEvaluator& evaluator_;
  const Streamline& line_;
  std::vector<double> s_;
  std::vector<Vec2> x_;
};

// Both lines and their blend at share f of the lengths.
struct Blend {
  Vec2 position, derivative;  ///< of M, with respect to f
  Vec2 along_a, along_b;      ///< unit directions of both lines, each its own way
};

Blend blend(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b, double length_a,
            double length_b, double f) {
  const double c = std::cos(half_pi * f), w = c * c, slope = -half_pi * std::sin(pi * f);
  Blend m;
  const Vec2 xa = a.at(evaluator, f * length_a, m.along_a), xb = b.at(evaluator, (1 - f) * length_b, m.along_b);
  m.position = w * xa + (1 - w) * xb;
  m.derivative = w * length_a * m.along_a - (1 - w) * length_b * m.along_b + slope * (xa - xb);
  return m;
}

// Fills in turn and gap; false where the rules don't allow the pair. The first sample that turns too far settles it:
// samples are taken far from each other first.
bool judge(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
           const MergeOptions& options, MergeCandidate& candidate) {
  const double la = candidate.length_a, lb = candidate.length_b;
  const double at_nodes =
      std::max(distance(a.at(evaluator, la), b.launch.origin), distance(b.at(evaluator, lb), a.launch.origin));
  candidate.gap = std::min(at_nodes, distance(a.at(evaluator, la / 2), b.at(evaluator, lb / 2)));
  if (candidate.gap > std::max(options.distance, std::tan(options.max_angle) * candidate.length())) return false;
  const bool aggressive = candidate.gap <= options.distance;
  const double most = aggressive ? std::max(options.max_angle, greatest_aggressive_angle) : options.max_angle;
  candidate.turn = 0;
  constexpr int stride = 19;  // no divisor in common with num_samples
  for (int i = stride; i != 0; i = (i + stride) % num_samples) {
    const double f = static_cast<double>(i) / num_samples, w = std::pow(std::cos(half_pi * f), 2);
    const Blend m = blend(evaluator, a, b, la, lb, f);
    candidate.turn = std::max(candidate.turn, angle_between(m.derivative, w * m.along_a - (1 - w) * m.along_b));
    if (candidate.turn > most) return false;
  }
  return true;
}

bool is_endless(const Streamline& line) { return line.end == Streamline::End::length; }

// The joined line at share f of its length: position, and derivative with respect to f.
Vec2 joined(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b, double length, double f,
            Vec2& derivative) {
  Vec2 along, along_end;
  const Vec2 x = a.at(evaluator, f * length, along), end = a.at(evaluator, length, along_end);
  const Vec2 shift = b.launch.origin - end, turn = -length * (unit(b.launch.angle) + along_end);
  derivative = length * along + 6 * f * (1 - f) * shift + f * (3 * f - 2) * turn;
  return x + f * f * ((3 - 2 * f) * shift - (1 - f) * turn);
}

// Fills in the turn of a joined line from the field that it runs through; false where that is too far, or outside.
bool judge_join(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                MergeCandidate& candidate) {
  double guide = a.launch.angle;
  candidate.turn = 0;
  for (int i = 1; i < num_samples; ++i) {
    Vec2 derivative, value;
    const double f = static_cast<double>(i) / num_samples;
    if (!evaluator.value_at(joined(evaluator, a, b, candidate.length_a, f, derivative), value)) return false;
    guide = guided_angle(value, guide);
    candidate.turn = std::max(candidate.turn, angle_between(derivative, unit(guide)));
    if (candidate.turn > greatest_aggressive_angle) return false;
  }
  return true;
}

// Whether two lengths are so unequal that the pair's fronts would not meet.
bool is_unequal(double a, double b) { return std::abs(a - b) > 0.3 * (a + b) / 2; }

// The same for all lengths within two passes.
bool are_unequal(const Pass& a, const Pass& b) {
  const double gap = std::max(a.low - b.high, b.low - a.high);
  return gap > 0.3 * (a.high + b.high) / 2;
}

// Between line a where it passes the start of line b, and b's way back.
double meeting_angle(const field::FieldEvaluator& evaluator, const Streamline& a, double length, const Streamline& b) {
  Vec2 direction;
  a.at(evaluator, length, direction);
  return angle_between(direction, -unit(b.launch.angle));
}

using PassTable = std::vector<std::vector<std::vector<Pass>>>;  // [line][node]

// The line of a node that most nearly comes the way of a line that passes there; -1: none does.
int line_against(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines, int passing,
                 double length, int node) {
  int best = -1;
  double least = head_on_angle;
  for (int j = 0; j < static_cast<int>(lines.size()); ++j) {
    if (lines[j].launch.node != node) continue;
    const double angle = meeting_angle(evaluator, lines[passing], length, lines[j]);
    if (angle < least) least = angle, best = j;
  }
  return best;
}

// Joins of lines that pass a node within the distance or end in it, where the pair is not one that merges already.
void add_joins(const field::FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
               const std::vector<Vec2>& nodes, double allowed, const std::vector<Passes>& along, PassTable& passes,
               std::vector<MergeCandidate>& candidates) {
  const size_t num_merges = candidates.size();
  const auto merges = [&](int i, int j) {
    return std::any_of(candidates.begin(), candidates.begin() + num_merges,
                       [&](const MergeCandidate& c) { return (c.a == i && c.b == j) || (c.a == j && c.b == i); });
  };
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    for (int node = 0; node < static_cast<int>(nodes.size()); ++node) {
      if (lines[i].launch.node < 0 || lines[i].launch.node == node) continue;
      if (allowed == 0 && lines[i].end_node != node) continue;
      for (Pass& pass : passes[i][node]) {
        const double length = along[i].foot(nodes[node], pass);
        const double gap = distance(lines[i].at(evaluator, length), nodes[node]);
        const int j = gap <= allowed ? line_against(evaluator, lines, i, length, node) : -1;
        if (j < 0 || merges(i, j)) continue;
        MergeCandidate join{i, j, length, length, 0, gap, true};
        if (judge_join(evaluator, lines[i], lines[j], join)) candidates.push_back(join);
      }
    }
  }
}

}  // namespace

curve::CurveFunction merged_curve(const field::FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                                  const MergeCandidate& candidate) {
  const double length = candidate.length(), la = candidate.length_a, lb = candidate.length_b;
  if (candidate.is_join)
    return [&evaluator, &a, &b, length](double s, Vec2& derivative) {
      const double f = std::clamp(s / length, 0.0, 1.0);
      const Vec2 x = joined(evaluator, a, b, length, f, derivative);
      derivative = derivative / length;
      return f == 0 ? a.launch.origin : f == 1 ? b.launch.origin : x;
    };
  return [&evaluator, &a, &b, length, la, lb](double s, Vec2& derivative) {
    const double f = std::clamp(s / length, 0.0, 1.0);
    const Blend m = blend(evaluator, a, b, la, lb, f);
    derivative = m.derivative / length;
    if (f == 0) return a.launch.origin;
    if (f == 1) return b.launch.origin;
    return m.position;
  };
}

std::vector<MergeCandidate> merge_candidates(const field::FieldEvaluator& evaluator,
                                             const std::vector<Streamline>& lines, const std::vector<Vec2>& nodes,
                                             const MergeOptions& options) {
  // passes[line][node]. The blend's slope adds at most (pi / 2) gap / length to the direction.
  const double slope = 2 * std::tan(options.max_angle);
  std::vector<Passes> along;
  PassTable passes;
  along.reserve(lines.size());
  for (const Streamline& line : lines) {
    along.emplace_back(evaluator, line);
    passes.emplace_back();
    for (const Vec2 node : nodes) passes.back().push_back(along.back().by(node, slope, 4 * options.distance));
  }
  std::vector<MergeCandidate> candidates;
  const int n = static_cast<int>(lines.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      const int from_i = lines[i].launch.node, from_j = lines[j].launch.node;
      if (from_i < 0 || from_j < 0) continue;
      if (options.only_endless && !is_endless(lines[i]) && !is_endless(lines[j])) continue;
      for (Pass& pass_i : passes[i][from_j])
        for (Pass& pass_j : passes[j][from_i]) {
          if (are_unequal(pass_i, pass_j)) continue;
          MergeCandidate c{i, j, along[i].foot(nodes[from_j], pass_i), along[j].foot(nodes[from_i], pass_j), 0, 0};
          if (is_unequal(c.length_a, c.length_b)) continue;
          if (meeting_angle(evaluator, lines[i], c.length_a, lines[j]) > head_on_angle) continue;
          if (meeting_angle(evaluator, lines[j], c.length_b, lines[i]) > head_on_angle) continue;
          if (judge(evaluator, lines[i], lines[j], options, c)) candidates.push_back(c);
        }
    }
  if (!options.only_endless) add_joins(evaluator, lines, nodes, options.distance, along, passes, candidates);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const MergeCandidate& x, const MergeCandidate& y) { return x.meeting() < y.meeting(); });
  return candidates;
}

std::vector<int> choose_merges(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed,
                               std::vector<bool>& taken) {
  std::vector<int> chosen;
  for (size_t first = 0; first < candidates.size();) {
    size_t last = first;
    const double same = candidates[first].meeting() * (1 + tie_share);
    while (last < candidates.size() && candidates[last].meeting() <= same) ++last;
    std::vector<int> wanted(taken.size(), 0), free;
    for (size_t i = first; i < last; ++i) {
      const MergeCandidate& c = candidates[i];
      if (!allowed[i] || taken[c.a] || taken[c.b]) continue;
      free.push_back(static_cast<int>(i));
      ++wanted[c.a], ++wanted[c.b];
    }
    for (const int i : free) {
      const MergeCandidate& c = candidates[i];
      if (wanted[c.a] > 1 || wanted[c.b] > 1) continue;
      taken[c.a] = taken[c.b] = true;
      chosen.push_back(i);
    }
    first = last;
  }
  return chosen;
}

}  // namespace quadrille::trace
