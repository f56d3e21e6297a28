#include "heal/heal_face.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "base/warning_codes.hpp"
#include "heal/chain_edges.hpp"
#include "heal/heal_rules.hpp"
#include "heal/heal_scale.hpp"
#include "heal/joint_limit.hpp"
#include "heal/merge_knots.hpp"
#include "heal/report_repair.hpp"
#include "heal/short_edges.hpp"
#include "heal/unfold.hpp"
#include "heal/yield_curve.hpp"

namespace quadrille::heal {
namespace {

using Wires = std::vector<std::vector<RawEdge>>;

// The curves are in the plane already: their heights were dropped when they were converted.
void project_edges(const Wires& wires, const HealScale& scale, std::vector<Repair>& repairs) {
  for (const auto& wire : wires)
    for (const RawEdge& edge : wire) {
      if (!(edge.height <= scale.most_off_plane))
        throw FormatError(fmt::format("{}: edge {} leaves the plane of the face by {:.3g}{}", scale.file, edge.cad_edge,
                                      edge.height, remedy(scale, edge.height)));
      if (edge.height > scale.rounding)
        repairs.push_back({RepairKind::plane, edge.cad_edge, edge.curve.poles.front(), edge.height});
    }
}

void unfold_splines(Wires& wires, const HealScale& scale, std::vector<Repair>& repairs) {
  for (auto& wire : wires)
    for (RawEdge& edge : wire) {
      const Nurbs old = edge.curve;
      const double moved = unfold(edge.curve, scale.tolerance);
      if (moved == 0) continue;
      const auto changed = std::mismatch(old.poles.begin(), old.poles.end(), edge.curve.poles.begin());
      repairs.push_back({RepairKind::fold, edge.cad_edge, *changed.first, moved});
    }
}

void merge_close_knots(Wires& wires, const HealScale& scale, std::vector<Repair>& repairs) {
  for (auto& wire : wires)
    for (RawEdge& edge : wire)
      if (const auto merged = merge_knots(edge.curve, scale.short_fraction * scale.diameter))
        repairs.push_back({RepairKind::knot, edge.cad_edge, merged->position, merged->length});
}

void put_in_order(std::vector<RawEdge>& wire, const HealScale& scale) {
  std::vector<const RawEdge*> edges;
  for (const RawEdge& edge : wire) edges.push_back(&edge);
  std::vector<RawEdge> ordered;
  for (const RawEdge* edge : chain_edges(edges, scale.rounding, 2 * scale.tolerance, scale.file))
    ordered.push_back(*edge);
  wire = std::move(ordered);
}

// The diagonal of the box of the wire's poles: what is short in a large outline may be a detail of a small hole.
double size_of(const std::vector<MeasuredEdge>& wire) {
  Vec2 low = wire.front().raw->curve.poles.front(), high = low;
  for (const MeasuredEdge& edge : wire)
    for (const Vec2 p : edge.raw->curve.poles) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  return distance(low, high);
}

void report_removed(const MeasuredEdge& edge, double length, const HealScale& scale, std::vector<Repair>& repairs,
                    Report& report) {
  report.warn(warning::short_edge_ignored,
              fmt::format("{}: ignored edge {} at {}: shorter than the tolerance {:.3g}", scale.file,
                          edge.raw->cad_edge, rounded_position_text(edge.raw->start), length));
  repairs.push_back({RepairKind::edge, edge.raw->cad_edge, edge.raw->start, edge.length});
}

void remove_short_edges(Wires& wires, const HealScale& scale, std::vector<Repair>& repairs, Report& report) {
  const JointLimit limit(wires, scale.tolerance);
  Wires kept;
  for (const auto& wire : measured(wires)) {
    const double length = scale.short_fraction * std::min(scale.diameter, size_of(wire));
    const std::vector<bool> removed = short_edges(wire, length, limit);
    kept.emplace_back();
    for (size_t i = 0; i < wire.size(); ++i)
      if (removed[i])
        report_removed(wire[i], length, scale, repairs, report);
      else
        kept.back().push_back(*wire[i].raw);
  }
  wires = std::move(kept);
}

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

/// The edges of the wire with their ends moved to one point where they lie further apart than rounding, each vertex at
/// the ends of its curves. All joints are computed from the old curves, so that their order does not matter.
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

void join_ends(Wires& wires, const HealScale& scale, std::vector<Repair>& repairs) {
  const JointLimit limit(wires, scale.tolerance);
  Wires joined;
  for (const auto& wire : measured(wires)) joined.push_back(join_wire(wire, scale, limit, repairs));
  wires = std::move(joined);
}

void report_repairs(const std::vector<Repair>& repairs, const HealScale& scale, Report& report) {
  double greatest = 0;
  for (const Repair& repair : repairs) greatest = std::max(greatest, repair.distance);
  report.set("heal.tolerance", scale.tolerance / scale.diameter);
  report.set("heal.repairs", repairs.size());
  report.set("heal.greatest", greatest / scale.diameter);
  for (size_t i = 0; i < repairs.size(); ++i) report_repair(repairs[i], i, report);
  if (greatest > heal_rules.large_tolerance * scale.diameter)
    report.warn(
        warning::large_repair,
        fmt::format("{}: the edges do not meet, or leave the plane, by up to {:.2g} diameters; they were healed: "
                    "look at the result, or give --heal-tolerance",
                    scale.file, greatest / scale.diameter));
}

}  // namespace

std::vector<Repair> heal_face(RawFace& raw, const HealOptions& options, double diameter, Report& report) {
  const HealScale scale = heal_scale(raw, options.tolerance, diameter);
  std::vector<Repair> repairs;
  project_edges(raw.wires, scale, repairs);
  if (scale.tolerance == 0) return {};
  unfold_splines(raw.wires, scale, repairs);
  merge_close_knots(raw.wires, scale, repairs);
  for (auto& wire : raw.wires) put_in_order(wire, scale);
  for (int pass = 0; pass < heal_rules.most_passes; ++pass) {
    const size_t before = repairs.size();
    remove_short_edges(raw.wires, scale, repairs, report);
    join_ends(raw.wires, scale, repairs);
    if (repairs.size() == before) break;
  }
  report_repairs(repairs, scale, report);
  return repairs;
}

}  // namespace quadrille::heal
