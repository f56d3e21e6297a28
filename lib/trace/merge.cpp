#include "trace/merge.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille {
namespace {

// Between a line where it passes a node and the line that leaves the node towards it. Lines turn where they pass a
// node, by about 45 degrees at their foot: what decides is the turn of the merged line.
constexpr double head_on_angle = radians(75);
constexpr double tie_share = 1e-6;  // lengths that differ by less are equal
constexpr int num_samples = 48;

double angle_between(Vec2 a, Vec2 b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); }

// Places where a line comes nearest to a point: arc lengths of local minima of the distance below `reach(s)`.
class Passes {
 public:
  Passes(const FieldEvaluator& evaluator, const Streamline& line) : evaluator_(evaluator), line_(line) {
    // Step ends and the middles between them follow the line closely enough to bracket every minimum.
    const std::vector<double> ends = line.step_ends();
    for (size_t i = 0; i < ends.size(); ++i) {
      if (i > 0 && ends[i] > ends[i - 1]) s_.push_back((ends[i - 1] + ends[i]) / 2);
      if (s_.empty() || ends[i] > s_.back()) s_.push_back(ends[i]);
    }
    for (const double s : s_) x_.push_back(line.at(evaluator, s));
  }

  std::vector<double> by(Vec2 node, double slope, double distance_allowed) const {
    std::vector<double> found;
    const size_t last = s_.size() - 1;
    double before = norm2(x_[0] - node), here = 0;
    for (size_t i = 1; i <= last; ++i, before = here) {
      here = norm2(x_[i] - node);
      if (here > before || (i < last && here >= norm2(x_[i + 1] - node))) continue;
      const double spacing = s_[i] - s_[i - 1] + (i < last ? s_[i + 1] - s_[i] : 0.0);
      const double reach = std::max(slope * s_[i], distance_allowed) + spacing;
      if (here > reach * reach) continue;
      if (i == last && !ends_beside(node)) continue;
      found.push_back(foot(node, s_[i - 1], i < last ? s_[i + 1] : s_[i]));
    }
    return found;
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
  double foot(Vec2 node, double a, double b) const {
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

  const FieldEvaluator& evaluator_;
  const Streamline& line_;
  std::vector<double> s_;
  std::vector<Vec2> x_;
};

// Fills in turn and gap; false, with the gap only, where that alone turns the line far more than allowed.
bool judge(const FieldEvaluator& evaluator, const Streamline& a, const Streamline& b, const MergeOptions& options,
           MergeCandidate& candidate) {
  const CurveFunction curve = merged_curve(evaluator, a, b, candidate);
  candidate.gap = distance(a.at(evaluator, candidate.length_a / 2), b.at(evaluator, candidate.length_b / 2));
  if (candidate.gap > std::max(options.distance, std::tan(options.max_angle) * candidate.length())) return false;
  candidate.turn = 0;
  for (int i = 1; i < num_samples; ++i) {
    const double f = static_cast<double>(i) / num_samples, w = std::pow(std::cos(half_pi * f), 2);
    Vec2 da, db, dm;
    a.at(evaluator, f * candidate.length_a, da);
    b.at(evaluator, (1 - f) * candidate.length_b, db);
    curve(f * candidate.length(), dm);
    candidate.turn = std::max(candidate.turn, angle_between(dm, w * da - (1 - w) * db));
  }
  return true;
}

}  // namespace

CurveFunction merged_curve(const FieldEvaluator& evaluator, const Streamline& a, const Streamline& b,
                           const MergeCandidate& candidate) {
  const double length = candidate.length(), la = candidate.length_a, lb = candidate.length_b;
  return [&evaluator, &a, &b, length, la, lb](double s, Vec2& derivative) {
    const double f = std::clamp(s / length, 0.0, 1.0), c = std::cos(half_pi * f), w = c * c;
    Vec2 da, db;
    const Vec2 xa = a.at(evaluator, f * la, da), xb = b.at(evaluator, (1 - f) * lb, db);
    const double slope = -half_pi * std::sin(pi * f);
    derivative = (w * la * da - (1 - w) * lb * db + slope * (xa - xb)) / length;
    if (f == 0) return a.launch.origin;
    if (f == 1) return b.launch.origin;
    return w * xa + (1 - w) * xb;
  };
}

std::vector<MergeCandidate> merge_candidates(const FieldEvaluator& evaluator, const std::vector<Streamline>& lines,
                                             const std::vector<Vec2>& nodes, const MergeOptions& options) {
  // passes[line][node]. The blend's slope adds at most (pi / 2) gap / length to the direction.
  const double slope = 2 * std::tan(options.max_angle);
  std::vector<std::vector<std::vector<double>>> passes;
  for (const Streamline& line : lines) {
    const Passes along(evaluator, line);
    passes.emplace_back();
    for (const Vec2 node : nodes) passes.back().push_back(along.by(node, slope, 4 * options.distance));
  }
  std::vector<MergeCandidate> candidates;
  const int n = static_cast<int>(lines.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      if (lines[i].launch.node < 0 || lines[j].launch.node < 0) continue;
      for (const double length_i : passes[i][lines[j].launch.node])
        for (const double length_j : passes[j][lines[i].launch.node]) {
          MergeCandidate c{i, j, length_i, length_j, 0, 0};
          if (std::abs(length_i - length_j) > 0.3 * c.length()) continue;
          Vec2 at_i, at_j;
          lines[i].at(evaluator, length_i, at_i);
          lines[j].at(evaluator, length_j, at_j);
          if (angle_between(at_i, -unit(lines[j].launch.angle)) > head_on_angle) continue;
          if (angle_between(at_j, -unit(lines[i].launch.angle)) > head_on_angle) continue;
          if (!judge(evaluator, lines[i], lines[j], options, c)) continue;
          const bool aggressive = c.gap <= options.distance && c.turn <= greatest_merge_angle;
          if (c.turn <= options.max_angle || aggressive) candidates.push_back(c);
        }
    }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const MergeCandidate& x, const MergeCandidate& y) { return x.length() < y.length(); });
  return candidates;
}

std::vector<int> choose_merges(const std::vector<MergeCandidate>& candidates, const std::vector<bool>& allowed,
                               std::vector<bool>& taken) {
  std::vector<int> chosen;
  for (size_t first = 0; first < candidates.size();) {
    size_t last = first;
    const double same = candidates[first].length() * (1 + tie_share);
    while (last < candidates.size() && candidates[last].length() <= same) ++last;
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

}  // namespace quadrille
