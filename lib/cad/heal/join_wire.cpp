#include "heal/join_wire.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "heal/yield_curve.hpp"

namespace quadrille::heal {
namespace {

// Where one edge ends and the next one begins from now on.
struct NewJoint {
  Vec2 end, start;
};

void check_vertices(const RawEdge& edge, const HealScale& scale) {
  for (const auto& [vertex, end] :
       {std::pair{edge.start, edge.curve.poles.front()}, std::pair{edge.end, edge.curve.poles.back()}}) {
    const double off = distance(vertex, end);
    if (off <= scale.most_off_curve) continue;
    throw FormatError(fmt::format("{}: edge {}: its vertex at {} lies {:.3g} off its curve{}", scale.file,
                                  edge.cad_edge, rounded_position_text(vertex), off, remedy(scale, off)));
  }
}

[[noreturn]] void refuse(const MeasuredEdge& in, const MeasuredEdge& out, const HealScale& scale,
                         const LimitedJoint& joint) {
  const Vec2 a = joint.in.end, b = joint.out.end;
  const std::string gap = fmt::format("{}: edges {} and {} are {:.3g} apart at {}", scale.file, in.raw->cad_edge,
                                      out.raw->cad_edge, distance(a, b), rounded_position_text(0.5 * (a + b)));
  if (joint.reason == LimitReason::tolerance)
    throw FormatError(gap + remedy(scale, needed_tolerance(joint.in, joint.out)));
  const std::string why =
      joint.reason == LimitReason::edge ? "a tenth of their length" : "a quarter of the distance to another edge";
  throw FormatError(fmt::format("{}; healing moves them by at most {:.3g} and {:.3g}, {}: draw them so that they meet",
                                gap, joint.in.most, joint.out.most, why));
}

NewJoint new_joint(const std::vector<MeasuredEdge>& wire, size_t i, const HealScale& scale, const JointLimit& limit,
                   std::vector<Repair>& repairs) {
  const size_t n = wire.size();
  const MeasuredEdge &in = wire[i], &out = wire[(i + 1) % n];
  const Vec2 end = in.raw->curve.poles.back(), start = out.raw->curve.poles.front();
  const double gap = distance(end, start);
  if (gap <= scale.rounding) {
    const double off = std::max(distance(in.raw->end, end), distance(out.raw->start, start));
    if (off > scale.rounding) repairs.push_back({RepairKind::vertex, in.raw->cad_edge, end, off});
    return {end, start};
  }
  const LimitedJoint joint = limit.joint(in, out, {wire[(i + n - 1) % n].raw, in.raw, out.raw, wire[(i + 2) % n].raw});
  const auto x = joint_target(joint.in, joint.out);
  if (!x) refuse(in, out, scale, joint);
  repairs.push_back({RepairKind::joint, in.raw->cad_edge, *x, std::max(distance(end, *x), distance(start, *x))});
  return {*x, *x};
}

void add_moved(const RawEdge& old, Vec2 start, Vec2 end, std::vector<RawEdge>& edges) {
  const bool stays = start == old.curve.poles.front() && end == old.curve.poles.back();
  const std::vector<Nurbs> pieces = stays ? std::vector<Nurbs>{old.curve} : moved_curve(old.curve, start, end);
  for (const Nurbs& piece : pieces) {
    RawEdge edge = old;
    edge.curve = piece;
    edge.start = piece.poles.front(), edge.end = piece.poles.back();
    edges.push_back(std::move(edge));
  }
}

}  // namespace

std::vector<RawEdge> join_wire(const std::vector<MeasuredEdge>& wire, const HealScale& scale, const JointLimit& limit,
                               std::vector<Repair>& repairs) {
  const size_t n = wire.size();
  for (const MeasuredEdge& edge : wire) check_vertices(*edge.raw, scale);
  std::vector<NewJoint> joints;
  for (size_t i = 0; i < n; ++i) joints.push_back(new_joint(wire, i, scale, limit, repairs));
  std::vector<RawEdge> edges;
  for (size_t i = 0; i < n; ++i) {
    const NewJoint& before = joints[(i + n - 1) % n];
    add_moved(*wire[i].raw, before.start, joints[i].end, edges);
  }
  return edges;
}

}  // namespace quadrille::heal
