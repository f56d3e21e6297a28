#include "sew/inner_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "outline/face_of_loops.hpp"

namespace quadrille::sew {

namespace {

/// Directions are compared at this part of the length of the shortest curve at the node.
constexpr double compared_at = 1e-3;

struct Node {
  std::vector<int> in, out;
  double shortest = 0;  ///< length of a curve
};

std::map<int, Node> nodes_of(const std::vector<SideOfCurve>& sides) {
  std::map<int, Node> nodes;
  for (int s = 0; s < static_cast<int>(sides.size()); ++s) {
    const double length = curve::ArcLength(sides[s].curve.curve).total();
    nodes[sides[s].from].out.push_back(s);
    nodes[sides[s].to].in.push_back(s);
    for (const int n : {sides[s].from, sides[s].to})
      nodes[n].shortest = nodes[n].shortest > 0 ? std::min(nodes[n].shortest, length) : length;
  }
  return nodes;
}

/// The direction in which the side leaves its start, or looks back from its end.
double angle_at(const Nurbs& curve, bool is_at_start, double away) {
  const curve::ArcLength length(curve);
  const double t = length.parameter(is_at_start ? away : length.total() - away);
  return angle_of(curve::point(curve, t) - (is_at_start ? curve.poles.front() : curve.poles.back()));
}

/// The side that starts next clockwise from the direction back along side `in`.
int successor(const std::vector<SideOfCurve>& sides, const Node& node, int in) {
  if (node.out.size() == 1) return node.out.front();
  const double away = compared_at * node.shortest;
  const double back = angle_at(sides[in].curve.curve, false, away);
  int best = -1;
  double least = 0;
  for (const int out : node.out) {
    const double turn =
        out == sides[in].twin ? 2 * pi : wrap_two_pi(back - angle_at(sides[out].curve.curve, true, away));
    if (best < 0 || turn < least) best = out, least = turn;
  }
  return best;
}

}  // namespace

std::vector<std::vector<int>> traced_loops(const std::vector<SideOfCurve>& sides) {
  std::vector<int> next(sides.size(), -1);
  for (const auto& [number, node] : nodes_of(sides))
    for (const int in : node.in) next[in] = successor(sides, node, in);
  std::vector<std::vector<int>> loops;
  std::vector<bool> is_done(sides.size(), false);
  for (int first = 0; first < static_cast<int>(sides.size()); ++first) {
    if (is_done[first]) continue;
    loops.emplace_back();
    for (int s = first; !is_done[s]; s = next[s]) {
      is_done[s] = true;
      loops.back().push_back(s);
    }
  }
  return loops;
}

namespace {

constexpr int num_samples = 32;
/// Of the length of an open wire: ends that are nearer to each other are a gap in a closed one.
constexpr double least_opening = 0.1;

double length_of(const std::vector<heal::RawEdge>& wire) {
  double length = 0;
  for (const heal::RawEdge& edge : wire) length += curve::ArcLength(edge.curve).total();
  return length;
}

curve::PoleBox box_of(const std::vector<heal::RawEdge>& wire) {
  std::vector<Nurbs> curves;
  for (const heal::RawEdge& edge : wire) curves.push_back(edge.curve);
  return curve::pole_box(curves);
}

/// The ends of edges of the wire that no other end meets.
std::vector<Vec2> loose_ends(const std::vector<heal::RawEdge>& wire, double tol) {
  std::vector<Vec2> ends, loose;
  for (const heal::RawEdge& edge : wire) ends.push_back(edge.start), ends.push_back(edge.end);
  for (size_t i = 0; i < ends.size(); ++i) {
    bool is_met = false;
    for (size_t j = 0; j < ends.size() && !is_met; ++j) is_met = i != j && distance(ends[i], ends[j]) <= tol;
    if (!is_met) loose.push_back(ends[i]);
  }
  return loose;
}

bool is_open(const std::vector<heal::RawEdge>& wire, double tol) {
  const std::vector<Vec2> loose = loose_ends(wire, tol);
  if (loose.size() < 2) return false;
  const double opening = least_opening * length_of(wire);
  for (size_t i = 0; i < loose.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (distance(loose[i], loose[j]) < opening) return false;
  return true;
}

std::vector<Vec2> samples_of(const Nurbs& curve) {
  const curve::ArcLength length(curve);
  std::vector<Vec2> samples;
  for (int i = 0; i <= num_samples; ++i)
    samples.push_back(curve::point(curve, length.parameter(length.total() * i / num_samples)));
  return samples;
}

enum class Position { outside, on_boundary, inside };

Position position_in(const std::vector<curve::CurveTree>& boundaries, Vec2 x, double tol) {
  Position position = Position::outside;
  for (const curve::CurveTree& boundary : boundaries) {
    if (boundary.nearest(x).distance <= tol)
      position = Position::on_boundary;
    else if (boundary.winding_number(x) > 0)
      return Position::inside;
  }
  return position;
}

std::vector<curve::CurveTree> boundaries_of(const std::vector<Region>& regions) {
  std::vector<curve::CurveTree> boundaries;
  for (const Region& region : regions) boundaries.push_back(boundary_of(region));
  return boundaries;
}

/// The first sample outside of all regions, or, if the curve is nowhere inside, any.
const Vec2* first_outside(const std::vector<curve::CurveTree>& regions, const std::vector<Vec2>& samples, double tol) {
  bool is_inside = false;
  for (const Vec2& x : samples) {
    const Position position = position_in(regions, x, tol);
    if (position == Position::outside) return &x;
    is_inside |= position == Position::inside;
  }
  return is_inside ? nullptr : &samples[num_samples / 2];
}

}  // namespace

void move_open_wires(heal::RawFace& raw, const heal::HealScale& scale, Report& report) {
  if (raw.wires.size() < 2) return;
  const auto smaller = [](const auto& a, const auto& b) { return box_of(a).diagonal() < box_of(b).diagonal(); };
  const auto outline = std::max_element(raw.wires.begin(), raw.wires.end(), smaller) - raw.wires.begin();
  std::vector<std::vector<heal::RawEdge>> closed;
  for (size_t w = 0; w < raw.wires.size(); ++w) {
    if (static_cast<long>(w) == outline || !is_open(raw.wires[w], 2 * scale.tolerance)) {
      closed.push_back(std::move(raw.wires[w]));
      continue;
    }
    report.warn(
        warning::open_wire_embedded,
        fmt::format("{}: the inner wire at {} is not closed and was taken as a curve with the face on both sides",
                    raw.file, rounded_position_text(raw.wires[w].front().start)));
    for (heal::RawEdge& edge : raw.wires[w]) raw.inner_edges.push_back(std::move(edge));
  }
  raw.wires = std::move(closed);
}

std::vector<heal::LoopCurve> embedded_edges(const std::vector<Region>& regions, const std::vector<heal::RawEdge>& edges,
                                            const heal::HealScale& scale, Report& report) {
  std::vector<heal::LoopCurve> curves;
  size_t num_ignored = 0;
  const std::vector<curve::CurveTree> boundaries = boundaries_of(regions);
  for (const heal::RawEdge& edge : edges) {
    if (!(edge.height <= scale.most_off_plane) ||
        first_outside(boundaries, samples_of(edge.curve), scale.tolerance) != nullptr) {
      ++num_ignored;
      continue;
    }
    for (heal::LoopCurve& piece : outline::smooth_pieces(edge)) curves.push_back(std::move(piece));
  }
  if (num_ignored > 0)
    report.warn(warning::curves_ignored,
                fmt::format("{}: ignored {} beside the face", scale.file, counted(num_ignored, "curve")));
  return curves;
}

std::vector<heal::LoopCurve> inner_curves(const Region& region, const std::vector<heal::RawEdge>& edges,
                                          const heal::HealScale& scale) {
  std::vector<heal::LoopCurve> curves;
  const std::vector<curve::CurveTree> boundary{boundary_of(region)};
  for (const heal::RawEdge& edge : edges) {
    const std::vector<Vec2> samples = samples_of(edge.curve);
    if (const Vec2* x = first_outside(boundary, samples, scale.tolerance))
      throw FormatError(
          fmt::format("{}: {}: edge {}, which bounds nothing, is not inside the face at {}: draw it inside, "
                      "or remove it",
                      scale.file, face_text(region), edge.cad_edge, rounded_position_text(*x)));
    for (heal::LoopCurve& piece : outline::smooth_pieces(edge)) curves.push_back(std::move(piece));
  }
  return curves;
}

void refuse_dangling_ends(const std::vector<Region>& regions, const std::vector<heal::LoopCurve>& curves,
                          const heal::HealScale& scale, double most_slip) {
  std::vector<const heal::LoopCurve*> others;
  for (const Region& region : regions)
    for (const heal::LoopCurve& c : region.curves) others.push_back(&c);
  for (const heal::LoopCurve& c : curves) others.push_back(&c);
  const curve::CurveTree all(others, [](const heal::LoopCurve* c) -> const Nurbs& { return c->curve; });
  for (const heal::LoopCurve& c : curves) {
    if (curve::has_smooth_seam(c.curve)) continue;
    for (const Vec2 end : {c.curve.poles.front(), c.curve.poles.back()}) {
      const curve::NearestPoint foot = all.nearest(end, [&](int o) { return others[o] != &c; });
      if (foot.distance <= scale.tolerance || !(foot.distance <= most_slip)) continue;
      throw FormatError(fmt::format("{}: the curve of edge {} ends at {}, {:.3g} before edge {}{}", scale.file,
                                    c.cad_edge, rounded_position_text(end), foot.distance, others[foot.curve]->cad_edge,
                                    heal::remedy(scale, foot.distance)));
    }
  }
}

}  // namespace quadrille::sew
