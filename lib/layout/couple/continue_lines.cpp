#include "couple/continue_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.hpp"
#include "curve/chain.hpp"
#include "curve/least_squares_spline.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/crossings.hpp"
#include "simplify/chord_blend.hpp"
#include "trace/advance.hpp"

namespace quadrille::couple {
namespace {

// Relative to the diameter of the region. A line that comes as near to a node as its hit distance is not continued.
constexpr trace::AdvanceOptions relative{1e-10, 1.0 / 20, 4, 1e-5};

// A point of a region's boundary, circles about the centre, before or after a rotation.
BoundaryPoint rotated(const CadFace& face, const curve::Rotation& rotation, const BoundaryPoint& point) {
  if (rotation.angle == 0) return point;
  return nearest_boundary_point(face, face.loop_of(point.curve), rotation.of(point.position(face)));
}

/// The field of a region, rotated as its layout was.
struct RotatedField {
  const field::FieldEvaluator& field;
  curve::Rotation rotation;
};

std::optional<TracedLine> traced_line(const graph::CandidateLayout& layout, const RotatedField& rotated_field,
                                      const BoundaryPoint& start) {
  const auto& [field, rotation] = rotated_field;
  const CadFace& face = layout.graph().face;
  const double d = face.diameter;
  std::vector<Vec2> nodes;
  for (const GraphNode& node : layout.graph().nodes)
    if (node.curve < 0) nodes.push_back(rotation.inverse().of(node.position));
  const BoundaryPoint before = rotated(face, rotation.inverse(), start);
  const trace::Streamline line = trace::advance(
      field, trace::launch_from_boundary(field, before.curve, before.t), PointGrid(std::move(nodes)),
      {relative.tolerance * d, relative.max_step * d, relative.max_length * d, relative.hit_distance * d});
  if (line.steps.empty()) return std::nullopt;
  const auto point = [&field = field, &rotation = rotation, &line](double s, Vec2& direction) {
    const Vec2 x = line.at(field, s, direction);
    direction = rotation.of_vector(direction);
    return rotation.of(x);
  };
  TracedLine traced;
  traced.spline = curve::fit_line(point, line.length(), graph::relative_fit_tol * d);
  traced.ends_on_boundary = line.end == trace::Streamline::End::boundary;
  if (traced.ends_on_boundary)
    traced.end = rotated(face, rotation, boundary_point(face, line.reached.curve, line.reached.t));
  return traced;
}

bool has_node_at(const SidePair& pair, int side, double position, double same) {
  return std::any_of(pair.nodes[side].begin(), pair.nodes[side].end(),
                     [&](const SideNode& node) { return pair.distance(node.position, position) <= same; });
}

std::vector<Continuation> traced_continuations(const RegionLayouts& regions, CutEnds cuts,
                                               const CanInsert& can_insert) {
  const CadFace& face = regions.face;
  std::vector<Continuation> found;
  for (const SidePair& pair : interface_sides(regions, cuts))
    for (const int side : {0, 1})
      for (const SideNode& node : pair.nodes[side]) {
        if (has_node_at(pair, 1 - side, node.position, relative_same * face.diameter)) continue;
        Continuation next;
        next.start = point_on_side(face, pair, 1 - side, regions.point_of(node.layout, node.node));
        next.region = regions.region_of_curve(next.start.curve);
        next.start.curve -= regions.first_curves[next.region];
        const graph::CandidateLayout& layout = regions.layouts[next.region];
        if (!can_insert(layout.subdivision, next.start)) continue;
        next.line = traced_line(layout, {*regions.fields[next.region], regions.rotation_of(next.region)}, next.start);
        found.push_back(std::move(next));
      }
  return found;
}

// How far, relative to their lengths, each of two lines through a region ends from where the other one starts.
double end_distance(const CadFace& face, const Continuation& a, const Continuation& b) {
  if (a.region != b.region || !a.line || !b.line || !a.line->ends_on_boundary || !b.line->ends_on_boundary)
    return INFINITY;
  const auto distance_to = [&](const Continuation& from, const Continuation& to) {
    return distance(from.line->end.position(face), to.start.position(face)) / from.line->spline.end();
  };
  return std::max(distance_to(a, b), distance_to(b, a));
}

// The line from the start of one to the start of the other, a blend (simplify/chord_blend.hpp).
TracedLine merged(const CadFace& face, const Continuation& a, const Continuation& b) {
  const std::vector<Nurbs> splines{a.line->spline, b.line->spline};
  const curve::CurveTable table(face, splines);
  const int first = face.num_curves();
  const curve::Chain from(table, {{first, splines[0].begin(), splines[0].end()}});
  const curve::Chain to(table, {{first + 1, splines[1].end(), splines[1].begin()}});
  return {curve::fit_line(simplify::blended_curve(from, to), simplify::blend_length(from, to),
                          graph::relative_fit_tol * face.diameter),
          true, b.start};
}

// Lines that cross a region in opposite directions, each the nearest to the other and not bent by more than
// `greatest_bend`, become one.
void merge_opposite_lines(const RegionLayouts& regions, std::vector<Continuation>& all) {
  const auto nearest = [&](std::size_t i) {
    std::optional<std::size_t> best;
    double least = greatest_bend;
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (i == j || all[i].region != all[j].region) continue;
      const double here = end_distance(regions.layouts[all[i].region].graph().face, all[i], all[j]);
      if (here >= least + tolerance::tied) continue;
      best = std::abs(here - least) <= tolerance::tied ? std::nullopt : std::optional(j);
      least = std::min(here, least);
    }
    return best;
  };
  std::vector<std::optional<std::size_t>> partners;
  for (std::size_t i = 0; i < all.size(); ++i) partners.push_back(nearest(i));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::optional<std::size_t> j = partners[i];
    if (!j || *j < i || partners[*j] != i) continue;
    all[i].line = merged(regions.layouts[all[i].region].graph().face, all[i], all[*j]);
    all[*j].line.reset();
  }
}

/// A point of an arc: `at.piece` counts the pieces of the half-edge.
struct ArcPoint {
  HalfEdge h;
  curve::ChainPoint at;
  bool is_end = false;  ///< the node at which the half-edge ends
};

// The arc that contains a parameter of a curve, not at its start.
std::optional<ArcPoint> point_on_arcs(const ArcGraph& graph, const std::vector<HalfEdge>& arcs, int curve, double t) {
  for (const HalfEdge h : arcs) {
    const graph::Pieces pieces = graph::pieces_along(graph, h);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto [low, high] = std::minmax(pieces[i].t0, pieces[i].t1);
      const double margin = tolerance::same_point * (high - low);  // nearer to an end of a piece is at the node
      const bool is_inner_joint = t == pieces[i].t0 && i > 0, is_last = i + 1 == pieces.size();
      const bool is_end = is_last && std::abs(t - pieces[i].t1) <= margin;
      const bool is_inside = t <= high - margin && (t >= low + margin || is_inner_joint);
      if (pieces[i].curve == curve && (is_inside || is_end))
        return ArcPoint{h, graph::point_on_piece(graph, pieces, i, t), is_end};
    }
  }
  return std::nullopt;
}

/// The sides of a face as seen from the arc on which a line enters it: `opposite` is what it may reach.
struct EnteredFace {
  std::vector<HalfEdge> opposite, others;
};

std::optional<EnteredFace> entered_face(const graph::Subdivision& subdivision, HalfEdge entry) {
  if (subdivision.num_corners(subdivision.face(entry)) != 4) return std::nullopt;
  EnteredFace face;
  int corners = 0;
  for (HalfEdge h = entry;;) {
    if (subdivision.quarters(h) < 1 || subdivision.quarters(h) > 2) return std::nullopt;
    if (subdivision.quarters(h) == 1) ++corners;
    h = subdivision.next(h);
    if (h == entry) return face;
    (corners == 2 ? face.opposite : face.others).push_back(h);
  }
}

// Where a line first crosses the splines of these arcs; `s`: its parameter there.
std::optional<ArcPoint> first_crossing(const ArcGraph& graph, const std::vector<HalfEdge>& arcs, const Nurbs& line,
                                       double same, double& s) {
  std::vector<int> curves;
  for (const HalfEdge h : arcs)
    for (const ArcPiece& piece : graph.arcs[h.arc].pieces)
      if (piece.curve >= graph.face.num_curves()) curves.push_back(piece.curve);
  std::sort(curves.begin(), curves.end());
  curves.erase(std::unique(curves.begin(), curves.end()), curves.end());
  std::vector<Nurbs> splines{line};
  for (const int c : curves) splines.push_back(graph.curve(c));
  graph::CrossingBounds bounds;
  bounds.sought.assign(splines.size(), false);
  bounds.sought[0] = true;
  for (const graph::Crossing& crossing : graph::find_crossings(splines, same, bounds)) {
    if (crossing.a != 0 || crossing.b == 0) continue;
    if (auto point = point_on_arcs(graph, arcs, curves[crossing.b - 1], crossing.t)) {
      s = crossing.s;
      return point;
    }
  }
  return std::nullopt;
}

/// Where a line leaves a face, with its parameter there.
struct FaceExit {
  ArcPoint point;
  double s = 0;
};

// Where the line leaves the face that it enters over a half-edge, if by the opposite side.
std::optional<FaceExit> exit_of_face(const graph::Subdivision& subdivision, HalfEdge entry, const TracedLine& line,
                                     double same) {
  const ArcGraph& graph = subdivision.graph();
  const std::optional<EnteredFace> face = entered_face(subdivision, entry);
  if (!face) return std::nullopt;
  double s = line.spline.end(), s_other = line.spline.end();
  std::optional<ArcPoint> exit = first_crossing(graph, face->opposite, line.spline, same, s);
  const bool crosses_other = first_crossing(graph, face->others, line.spline, same, s_other).has_value();
  if (!exit && line.ends_on_boundary) exit = point_on_arcs(graph, face->opposite, line.end.curve, line.end.t);
  if (!exit || (crosses_other && s_other < s)) return std::nullopt;
  if (exit->is_end && subdivision.quarters(exit->h) != 2) return std::nullopt;
  return FaceExit{*exit, s};
}

// The faces that the line divides, by the points where it leaves them. It may end on lines of earlier rounds (those of
// this round have the splines from `first_new` on) and where another line ends on the far side. With
// ContinueTo::first_line it ends at the first such place, with ContinueTo::boundary at the last one that it reaches
// through opposite sides of faces. Empty if it reaches none.
std::vector<FaceExit> exits_of_line(const graph::Subdivision& subdivision, HalfEdge entry, const TracedLine& line,
                                    double same, int first_new, ContinueTo limit) {
  const ArcGraph& graph = subdivision.graph();
  std::vector<FaceExit> exits;
  std::size_t num_certain = 0;
  for (;;) {
    const std::optional<FaceExit> exit = exit_of_face(subdivision, entry, line, same);
    if (!exit || (!exits.empty() && exit->s <= exits.back().s)) break;
    exits.push_back(*exit);
    entry = exit->point.h.reversed();
    const bool is_new = graph.arcs[entry.arc].pieces.front().curve - graph.face.num_curves() >= first_new;
    const bool may_end = exit->point.is_end || !is_new;
    if (may_end) num_certain = exits.size();
    const bool is_last = exit->point.is_end || graph.arcs[entry.arc].is_boundary;
    if (is_last || (may_end && limit == ContinueTo::first_line)) break;
  }
  exits.resize(num_certain);
  return exits;
}

// Where a line that starts on the boundary enters a face that it can divide.
std::optional<ArcPoint> entry_at(const graph::Subdivision& subdivision, const BoundaryPoint& start) {
  const ArcGraph& graph = subdivision.graph();
  std::vector<HalfEdge> boundary;
  for (int a = 0; a < subdivision.arc_bound(); ++a)
    if (subdivision.has_arc(a) && graph.arcs[a].is_boundary) boundary.push_back({a});
  const std::optional<ArcPoint> entry = point_on_arcs(graph, boundary, start.curve, start.t);
  return entry && !entry->is_end && entered_face(subdivision, entry->h) ? entry : std::nullopt;
}

// Divides the faces that the line enters, if it reaches the opposite sides.
bool insert_line(graph::CandidateLayout& layout, TracedLine line, const BoundaryPoint& start, int first_new,
                 ContinueTo limit) {
  graph::Subdivision& subdivision = layout.subdivision;
  const ArcGraph& graph = subdivision.graph();
  const std::optional<ArcPoint> entry = entry_at(subdivision, start);
  if (!entry) return false;
  const std::vector<FaceExit> exits =
      exits_of_line(subdivision, entry->h, line, relative_same * graph.face.diameter, first_new, limit);
  if (exits.empty()) return false;
  const auto begin = graph::divide_at_point(subdivision, entry->h, entry->at);
  Nurbs& spline = line.spline;
  spline.poles.front() = graph.nodes[begin.node].position;
  const ArcPoint& last = exits.back().point;
  if (exits.back().s == spline.end())
    spline.poles.back() = last.is_end ? graph.nodes[subdivision.end(last.h)].position : last.at.position;
  double s = spline.begin();
  const int curve = subdivision.add_spline(std::move(spline));
  HalfEdge from = begin.first;
  for (const FaceExit& exit : exits) {
    if (exit.point.is_end) {
      subdivision.insert_arc({from}, {exit.point.h}, {{curve, s, exit.s}});
      break;
    }
    const auto end = graph::divide_at_point(subdivision, exit.point.h, exit.point.at);
    subdivision.insert_arc({from}, {end.first}, {{curve, s, exit.s}});
    from = end.second.reversed();
    s = exit.s;
  }
  return true;
}

}  // namespace

std::vector<Continuation> continuations(const RegionLayouts& regions, CutEnds cuts, const CanInsert& can_insert) {
  std::vector<Continuation> all = traced_continuations(regions, cuts, can_insert);
  merge_opposite_lines(regions, all);
  return all;
}

int continue_lines(RegionLayouts& regions, CutEnds cuts, ContinueTo limit) {
  std::vector<std::vector<LineKind>> kinds = regions.line_kinds();
  std::vector<int> first_new;  // spline of each region
  for (const graph::CandidateLayout& layout : regions.layouts)
    first_new.push_back(static_cast<int>(layout.graph().splines.size()));
  std::vector<Continuation> all = continuations(
      regions, cuts,
      [](const graph::Subdivision& s, const BoundaryPoint& start) { return entry_at(s, start).has_value(); });
  int num_lines = 0;
  for (Continuation& next : all)
    if (next.line)
      num_lines +=
          insert_line(regions.layouts[next.region], std::move(*next.line), next.start, first_new[next.region], limit);
  regions.rebuild_lines(std::move(kinds), LineKind::traced);
  return num_lines;
}

int remove_needless_cuts(RegionLayouts& regions) {
  int num_removed = 0;
  std::vector<std::vector<LineKind>> kinds = regions.line_kinds();
  for (std::size_t r = 0; r < regions.layouts.size(); ++r) {
    graph::CandidateLayout& layout = regions.layouts[r];
    graph::Subdivision& subdivision = layout.subdivision;
    const int num_curves = layout.graph().face.num_curves();
    for (int a = 0; a < subdivision.arc_bound(); ++a) {
      if (!subdivision.has_arc(a)) continue;
      const int spline = layout.graph().arcs[a].pieces.front().curve - num_curves;
      if (spline < 0 || kinds[r][spline] != LineKind::cut) continue;
      const int from = subdivision.start({a}), to = subdivision.end({a});
      const auto is_single_end = [&](int node) {
        return layout.graph().nodes[node].curve >= 0 && subdivision.around(node).size() == 3;
      };
      if (!is_single_end(from) || !is_single_end(to) || !subdivision.remove_arc(a)) continue;
      for (const int node : {from, to}) subdivision.dissolve_node(node);
      ++num_removed;
    }
    subdivision.compact();
  }
  regions.rebuild_lines(std::move(kinds), LineKind::traced);
  return num_removed;
}

}  // namespace quadrille::couple
