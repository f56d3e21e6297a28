#include "heal/heal_face.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "heal/heal_rules.hpp"
#include "heal/joint_target.hpp"
#include "heal/wire_edges.hpp"

namespace quadrille::heal {

namespace {

// Whether the leg from pole i to the next one runs against the legs before and behind it. The ends of the curve stay.
bool is_fold(const std::vector<Vec2>& poles, size_t i, double most) {
  const Vec2 before = poles[i] - poles[i - 1], leg = poles[i + 1] - poles[i], behind = poles[i + 2] - poles[i + 1];
  return norm(leg) <= most && dot(before, leg) < 0 && dot(leg, behind) < 0;
}

// Exchanges the two poles of the first fold. Returns false if no leg is a fold.
bool exchange_one(std::vector<Vec2>& poles, double most) {
  for (size_t i = 1; i + 2 < poles.size(); ++i) {
    if (!is_fold(poles, i, most)) continue;
    std::swap(poles[i], poles[i + 1]);
    return true;
  }
  return false;
}

double greatest_distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double greatest = 0;
  for (size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, distance(a[i], b[i]));
  return greatest;
}

}  // namespace

double unfold(Nurbs& curve, double most) {
  std::vector<Vec2> poles = curve.poles;
  // An exchange can make the leg before it a fold, which comes next: as when sorting by insertion, each pole passes
  // every other one at most once.
  for (size_t left = poles.size() * poles.size(); exchange_one(poles, most); --left)
    if (left == 0) return 0;
  const double moved = greatest_distance(poles, curve.poles);
  if (moved > most) return 0;
  curve.poles = std::move(poles);
  return moved;
}

namespace {

// Breaks that become one, with their parameter from then on.
struct Cluster {
  double low = 0, high = 0, target = 0;
  MergedKnots merged;
};

std::vector<Cluster> clusters_of(const Nurbs& curve, double most) {
  std::vector<double> breaks{curve.begin()};
  for (const double t : curve::smoothness_breaks(curve)) breaks.push_back(t);
  breaks.push_back(curve.end());
  const curve::ArcLength length(curve);
  std::vector<Cluster> clusters;
  for (size_t i = 0, next = 1; i < breaks.size(); i = next, ++next) {
    while (next < breaks.size() && length.between(breaks[i], breaks[next]) <= most) ++next;
    if (next == i + 1) continue;
    const double low = breaks[i], high = breaks[next - 1];
    const double target = i == 0 ? low : next == breaks.size() ? high : (low + high) / 2;
    clusters.push_back({low, high, target, {curve::point(curve, target), length.between(low, high)}});
  }
  return clusters;
}

// Poles from number `first` on, `count` of them, become one between the first and the last of them.
void unite_poles(Nurbs& curve, size_t first, size_t count) {
  const size_t last = first + count - 1;
  curve.poles[first] = 0.5 * (curve.poles[first] + curve.poles[last]);
  curve.weights[first] = 0.5 * (curve.weights[first] + curve.weights[last]);
  const auto erase = [&](auto& values) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                 values.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  };
  erase(curve.poles), erase(curve.weights);
}

// A knot of multiplicity m > degree inside the curve has m - degree + 1 poles that the curve comes to, from its left,
// nowhere or from its right; the ends of the curve, of multiplicity degree + 1, keep their outermost pole.
void limit_multiplicity(Nurbs& curve, double knot) {
  const auto first = std::lower_bound(curve.knots.begin(), curve.knots.end(), knot);
  const auto last = std::upper_bound(first, curve.knots.end(), knot);
  const bool is_begin = first == curve.knots.begin(), is_end = last == curve.knots.end();
  const std::ptrdiff_t most = curve.degree + (is_begin || is_end ? 1 : 0), excess = (last - first) - most;
  if (excess <= 0) return;
  const size_t before = static_cast<size_t>(first - curve.knots.begin());
  const size_t num_united = static_cast<size_t>(excess) + 1;
  const size_t start = is_begin ? 0 : is_end ? curve.poles.size() - num_united : before - 1;
  const Vec2 outer = is_begin ? curve.poles.front() : curve.poles.back();
  const double weight = is_begin ? curve.weights.front() : curve.weights.back();
  unite_poles(curve, start, num_united);
  if (is_begin || is_end) curve.poles[start] = outer, curve.weights[start] = weight;
  curve.knots.erase(first, first + excess);
}

}  // namespace

std::optional<MergedKnots> merge_knots(Nurbs& curve, double most) {
  const std::vector<Cluster> clusters = clusters_of(curve, most);
  if (clusters.empty()) return std::nullopt;
  if (clusters.front().low == curve.begin() && clusters.front().high == curve.end()) return std::nullopt;
  for (const Cluster& c : clusters) {
    for (double& knot : curve.knots)
      if (c.low <= knot && knot <= c.high) knot = c.target;
    limit_multiplicity(curve, c.target);
  }
  return std::max_element(clusters.begin(), clusters.end(),
                          [](const Cluster& a, const Cluster& b) { return a.merged.length < b.merged.length; })
      ->merged;
}

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
