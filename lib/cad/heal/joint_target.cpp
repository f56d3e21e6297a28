#include "heal/joint_target.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "heal/heal_rules.hpp"

namespace quadrille::heal {
namespace {

bool is_line(const JointSide& side) { return side.carrier.kind == curve::CurveKind::line; }

bool is_multiple_of_kept_angle(double angle) {
  return std::abs(std::remainder(angle, heal_rules.kept_angle)) <= heal_rules.same_angle;
}

// The lines whose direction another line has, too; `angles` in [0, pi), sorted, with the number of the line.
void keep_parallels(const std::vector<std::pair<double, size_t>>& angles, std::vector<Rank>& ranks) {
  for (size_t i = 0; i < angles.size(); ++i) {
    const auto& [angle, line] = angles[i];
    const auto& [next, other] = angles[(i + 1) % angles.size()];
    if (line == other || std::abs(std::remainder(next - angle, pi)) > heal_rules.same_angle) continue;
    ranks[line] = ranks[other] = Rank::kept_line;
  }
}

bool meet_tangentially(const JointSide& a, const JointSide& b) {
  return std::abs(cross(a.tangent, b.tangent)) <= std::sin(heal_rules.tangential) * (1 + 1e-6);
}

bool have_intersection_only(const JointSide& a, const JointSide& b) {
  return std::min(a.rank, b.rank) == Rank::kept_line && !meet_tangentially(a, b);
}

// The rule for lines and arcs; std::nullopt if it gives no point.
std::optional<Vec2> by_carriers(const JointSide& a, const JointSide& b, Vec2 middle) {
  if (!meet_tangentially(a, b)) return curve::intersection(a.carrier, b.carrier, middle);
  const JointSide &line = is_line(a) ? a : b, &other = is_line(a) ? b : a;
  if (is_line(line) && other.carrier.kind == curve::CurveKind::arc)
    return curve::nearest_on(line.carrier, other.carrier.point);
  return std::nullopt;
}

bool may_move(const JointSide& side, Vec2 x) {
  const double far = distance(x, side.end);
  if (far <= side.most * (1 + 1e-6)) return true;
  const bool slides = is_line(side) && distance(curve::nearest_on(side.carrier, x), x) <= heal_rules.same_angle * far;
  return slides && far <= side.most_sliding * (1 + 1e-6);
}

Vec2 by_rank(const JointSide& a, const JointSide& b, Vec2 middle) {
  if (a.rank == b.rank) return middle;
  const JointSide& kept = a.rank > b.rank ? a : b;
  return curve::nearest_on(kept.carrier, middle);
}

}  // namespace

std::vector<Rank> ranks_of(const std::vector<curve::Carrier>& carriers) {
  std::vector<Rank> ranks;
  std::vector<std::pair<double, size_t>> angles;
  for (const curve::Carrier& c : carriers) {
    const double angle = wrap_two_pi(2 * angle_of(c.direction)) / 2;
    const bool line = c.kind == curve::CurveKind::line;
    if (line) angles.emplace_back(angle, ranks.size());
    ranks.push_back(!line                              ? c.kind == curve::CurveKind::arc ? Rank::arc : Rank::spline
                    : is_multiple_of_kept_angle(angle) ? Rank::kept_line
                                                       : Rank::line);
  }
  std::sort(angles.begin(), angles.end());
  keep_parallels(angles, ranks);
  return ranks;
}

double needed_tolerance(const JointSide& a, const JointSide& b) {
  const double gap = distance(a.end, b.end);
  if (!have_intersection_only(a, b)) return gap;
  const auto x = by_carriers(a, b, 0.5 * (a.end + b.end));
  return x ? std::max(gap, std::max(distance(*x, a.end), distance(*x, b.end)) / heal_rules.sliding_reach) : gap;
}

std::optional<Vec2> joint_target(const JointSide& a, const JointSide& b) {
  const Vec2 middle = 0.5 * (a.end + b.end);
  const auto x = by_carriers(a, b, middle);
  if (x && may_move(a, *x) && may_move(b, *x)) return x;
  if (have_intersection_only(a, b)) return std::nullopt;
  for (const Vec2 y : {by_rank(a, b, middle), a.most < b.most ? a.end : b.end})
    if (may_move(a, y) && may_move(b, y)) return y;
  return std::nullopt;
}

}  // namespace quadrille::heal
