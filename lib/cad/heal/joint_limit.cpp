#include "heal/joint_limit.hpp"

#include <algorithm>

#include "curve/project.hpp"
#include "heal/heal_rules.hpp"

namespace quadrille::heal {

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
    const Vec2 inside{std::clamp(x.x, box.low.x, box.high.x), std::clamp(x.y, box.low.y, box.high.y)};
    if (distance(x, inside) >= most) continue;
    if (std::find(ignored.begin(), ignored.end(), edge) != ignored.end()) continue;
    most = std::min(most, curve::project(edge->curve, x).distance);
  }
  return most;
}

}  // namespace quadrille::heal
