#include "heal/joint_target.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"
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

std::vector<std::vector<MeasuredEdge>> measured(const std::vector<std::vector<RawEdge>>& wires) {
  std::vector<std::vector<MeasuredEdge>> result;
  std::vector<curve::Carrier> carriers;
  for (const auto& wire : wires) {
    result.emplace_back();
    for (const RawEdge& edge : wire) {
      carriers.push_back(curve::carrier_of(edge.curve));
      result.back().push_back({&edge, carriers.back(), {}, curve::ArcLength(edge.curve).total()});
    }
  }
  const std::vector<Rank> ranks = ranks_of(carriers);
  size_t next = 0;
  for (auto& wire : result)
    for (MeasuredEdge& edge : wire) edge.rank = ranks[next++];
  return result;
}

JointSide end_of(const MeasuredEdge& edge) {
  const Nurbs& c = edge.raw->curve;
  return {edge.carrier, edge.rank, c.poles.back(), curve::tangent(c, c.end(), true)};
}

JointSide start_of(const MeasuredEdge& edge) {
  const Nurbs& c = edge.raw->curve;
  return {edge.carrier, edge.rank, c.poles.front(), curve::tangent(c, c.begin())};
}

JointLimit::JointLimit(const std::vector<std::vector<RawEdge>>& wires, double tolerance) : tolerance_(tolerance) {
  for (const auto& wire : wires)
    for (const RawEdge& edge : wire) edges_.push_back({&edge, curve::pole_box(edge.curve)});
}

LimitedJoint JointLimit::joint(const MeasuredEdge& in, const MeasuredEdge& out,
                               const std::vector<const RawEdge*>& near) const {
  LimitedJoint joint{end_of(in), start_of(out)};
  const double reach = heal_rules.sliding_reach * tolerance_, most = reach / heal_rules.clearance_fraction;
  const double free = clearance(0.5 * (joint.in.end + joint.out.end), near, most);
  const double limit = std::min(tolerance_, heal_rules.clearance_fraction * free);
  // Where lines cross at a small angle, a gap within the tolerance puts their intersection beyond it.
  const bool is_near = distance(joint.in.end, joint.out.end) <= tolerance_;
  const double sliding = is_near ? std::min(reach, heal_rules.clearance_fraction * free) : limit;
  joint.in.most = std::min(limit, heal_rules.edge_fraction * in.length);
  joint.out.most = std::min(limit, heal_rules.edge_fraction * out.length);
  joint.in.most_sliding = std::min(sliding, heal_rules.sliding_fraction * in.length);
  joint.out.most_sliding = std::min(sliding, heal_rules.sliding_fraction * out.length);
  joint.reason = std::min(joint.in.most, joint.out.most) < limit ? LimitReason::edge
                 : limit < tolerance_                            ? LimitReason::clearance
                                                                 : LimitReason::tolerance;
  return joint;
}

// The distance of x from the edges that are not ignored, or `most` if that is less.
double JointLimit::clearance(Vec2 x, const std::vector<const RawEdge*>& ignored, double most) const {
  for (const auto& [edge, box] : edges_) {
    if (box.distance_from(x) >= most) continue;
    if (std::find(ignored.begin(), ignored.end(), edge) != ignored.end()) continue;
    most = std::min(most, curve::project(edge->curve, x).distance);
  }
  return most;
}

namespace {

// The part of the arc's circle from the point nearest to `start` to the one nearest to `end`, in the sense of the arc.
Nurbs arc_between(const curve::Carrier& circle, const Nurbs& arc, Vec2 start, Vec2 end) {
  const Vec2 from = arc.poles.front() - circle.point, to = arc.poles.back() - circle.point;
  const auto shift = [&](Vec2 radial, Vec2 x) {
    const Vec2 d = x - circle.point;
    return std::atan2(cross(radial, d), dot(radial, d));
  };
  const double sense = cross(from, curve::tangent(arc, arc.begin())) > 0 ? 1 : -1;
  const double turn = wrap_two_pi(sense * std::atan2(cross(from, to), dot(from, to)));
  const bool is_whole = std::min(turn, 2 * pi - turn) < 1e-3 &&
                        distance(curve::point(arc, (arc.begin() + arc.end()) / 2), circle.point - from) < circle.radius;
  const double sweep = !is_whole ? turn : turn < pi ? turn + 2 * pi : turn;
  const double angle0 = angle_of(from), shift0 = shift(from, start), shift1 = shift(to, end);
  return curve::circular_arc(circle.point, circle.radius, angle0 + shift0, angle0 + sense * sweep + shift1);
}

// Whether the ends of the curve are already at `start` and `end`, up to rounding.
bool ends_at(const Nurbs& curve, Vec2 start, Vec2 end) {
  const double rounding = 1e-14 * (norm(start) + norm(end) + distance(start, end));
  return distance(curve.poles.front(), start) <= rounding && distance(curve.poles.back(), end) <= rounding;
}

// The greatest distance of a point of the curve from its start.
double reach(const Nurbs& curve) {
  double greatest = 0;
  constexpr int samples = 16;
  for (int i = 1; i <= samples; ++i) {
    const double t = curve.begin() + (curve.end() - curve.begin()) * i / samples;
    greatest = std::max(greatest, distance(curve.poles.front(), curve::point(curve, t)));
  }
  return greatest;
}

// z -> start + (end - start) / (b - a) (z - a), with complex numbers.
Nurbs similar(Nurbs curve, Vec2 start, Vec2 end) {
  const Vec2 a = curve.poles.front(), chord = curve.poles.back() - a, target = end - start;
  if (norm2(chord) > 0) {
    const Vec2 ratio = Vec2{dot(chord, target), cross(chord, target)} / norm2(chord);
    for (Vec2& z : curve.poles) z = start + Vec2{dot({ratio.x, -ratio.y}, z - a), cross({ratio.x, -ratio.y}, z - a)};
  }
  return curve;
}

void add_moved(const Nurbs& curve, Vec2 start, Vec2 end, int cuts, std::vector<Nurbs>& pieces) {
  const double chord = distance(curve.poles.front(), curve.poles.back());
  const bool ends_there = ends_at(curve, start, end);
  if (ends_there || cuts == 0 || chord >= heal_rules.least_chord * reach(curve) * (1 - 1e-6)) {
    pieces.push_back(ends_there ? curve : similar(curve, start, end));
    pieces.back().poles.front() = start, pieces.back().poles.back() = end;
    return;
  }
  const double middle = (curve.begin() + curve.end()) / 2;
  const Vec2 point = curve::point(curve, middle);
  add_moved(curve::trimmed(curve, curve.begin(), middle), start, point, cuts - 1, pieces);
  add_moved(curve::trimmed(curve, middle, curve.end()), point, end, cuts - 1, pieces);
}

}  // namespace

std::vector<Nurbs> moved_curve(const Nurbs& curve, Vec2 start, Vec2 end) {
  const curve::Carrier carrier = curve::carrier_of(curve);
  if (carrier.kind == curve::CurveKind::line) return {curve::segment(start, end)};
  std::vector<Nurbs> pieces;
  const bool is_arc = carrier.kind == curve::CurveKind::arc;
  add_moved(is_arc ? arc_between(carrier, curve, start, end) : curve, start, end, heal_rules.most_cuts, pieces);
  return pieces;
}

}  // namespace quadrille::heal
