#include "couple/continue_lines.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "couple/interface_chains.hpp"
#include "couple/renew_lines.hpp"
#include "curve/fit_line.hpp"
#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/crossings.hpp"
#include "graph/divide_at_point.hpp"
#include "graph/separatrix_lines.hpp"
#include "trace/advance.hpp"

namespace quadrille::couple {
namespace {

// All relative to the diameter of the region.
constexpr double relative_same = 1e-8;        // a line nearer than this to a node ends there already
constexpr double relative_tolerance = 1e-10;  // of a step
constexpr double relative_step = 1.0 / 20;    // the greatest
constexpr double relative_hit = 1e-5;         // a line that comes nearer to a node is not continued
constexpr double relative_length = 4;         // the greatest of a line
constexpr double relative_fit_tol = 2e-9;     // as for traced lines
constexpr double relative_end = 1e-6;         // of a piece: crossings nearer to its ends are at a node

/// A point of an arc: `at.piece` counts the pieces of the half-edge.
struct ArcPoint {
  HalfEdge h;
  curve::ChainPoint at;
};

curve::ChainPoint chain_point(const ArcGraph& graph, const graph::Pieces& pieces, int piece, double t) {
  const ArcPiece& p = pieces[piece];
  const Nurbs& curve = graph.curve(p.curve);
  const Vec2 along = curve::tangent(curve, t);
  return {curve::point(curve, t), p.t0 < p.t1 ? along : -along, piece, t};
}

// The arc that contains a parameter of a curve, not at its ends.
std::optional<ArcPoint> point_on_arcs(const ArcGraph& graph, const std::vector<HalfEdge>& arcs, int curve, double t) {
  for (const HalfEdge h : arcs) {
    const graph::Pieces pieces = graph::pieces_along(graph, h);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto [low, high] = std::minmax(pieces[i].t0, pieces[i].t1);
      const double margin = relative_end * (high - low);
      const bool is_inner_joint = t == pieces[i].t0 && i > 0;
      if (pieces[i].curve != curve || t > high - margin || (t < low + margin && !is_inner_joint)) continue;
      return ArcPoint{h, chain_point(graph, pieces, static_cast<int>(i), t)};
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

/// A line through one region.
struct TracedLine {
  Nurbs spline;
  bool ends_on_boundary = false;
  Place end;  ///< in the region
};

std::optional<TracedLine> traced_line(const graph::CandidateLayout& layout, const field::FieldEvaluator& field,
                                      const Place& start) {
  const double d = layout.graph().face.diameter;
  std::vector<Vec2> nodes;
  for (const GraphNode& node : layout.graph().nodes)
    if (node.curve < 0) nodes.push_back(node.position);
  const trace::Streamline line =
      trace::advance(field, trace::launch_from_boundary(field, start.curve, start.t), PointGrid(std::move(nodes)),
                     {relative_tolerance * d, relative_step * d, relative_length * d, relative_hit * d});
  if (line.steps.empty()) return std::nullopt;
  TracedLine traced;
  traced.spline = curve::fit_line([&](double s, Vec2& direction) { return line.at(field, s, direction); },
                                  line.length(), relative_fit_tol * d);
  traced.ends_on_boundary = line.end == trace::Streamline::End::boundary;
  if (traced.ends_on_boundary) traced.end = place_at(layout.graph().face, line.reached.curve, line.reached.t);
  return traced;
}

// Divides the face that the line enters, if it reaches the opposite side.
bool insert_line(graph::CandidateLayout& layout, const field::FieldEvaluator& field, const Place& start) {
  graph::Subdivision& subdivision = layout.subdivision;
  const ArcGraph& graph = subdivision.graph();
  std::vector<HalfEdge> boundary;
  for (int a = 0; a < subdivision.arc_bound(); ++a)
    if (subdivision.has_arc(a) && graph.arcs[a].is_boundary) boundary.push_back({a});
  const std::optional<ArcPoint> entry = point_on_arcs(graph, boundary, start.curve, start.t);
  if (!entry) return false;
  const std::optional<EnteredFace> face = entered_face(subdivision, entry->h);
  std::optional<TracedLine> line = face ? traced_line(layout, field, start) : std::nullopt;
  if (!line) return false;
  const double same = relative_same * graph.face.diameter;
  double s = line->spline.end(), s_other = line->spline.end();
  std::optional<ArcPoint> exit = first_crossing(graph, face->opposite, line->spline, same, s);
  const bool crosses_other = first_crossing(graph, face->others, line->spline, same, s_other).has_value();
  if (!exit && line->ends_on_boundary) exit = point_on_arcs(graph, face->opposite, line->end.curve, line->end.t);
  if (!exit || (crosses_other && s_other < s)) return false;
  const auto end = graph::divide_at_point(subdivision, exit->h, exit->at);
  const auto begin = graph::divide_at_point(subdivision, entry->h, entry->at);
  Nurbs spline = std::move(line->spline);
  spline.poles.front() = graph.nodes[begin.node].position;
  if (s == spline.end()) spline.poles.back() = graph.nodes[end.node].position;
  const double first = spline.begin();
  const int curve = subdivision.add_spline(std::move(spline));
  subdivision.insert_arc({begin.first}, {end.first}, {{curve, first, s}});
  return true;
}

bool has_station_at(const InterfaceChain& chain, int side, double position, double same) {
  return std::any_of(chain.stations[side].begin(), chain.stations[side].end(), [&](const Station& s) {
    const double d = std::abs(s.position - position);
    return std::min(d, chain.is_closed ? chain.length() - d : d) <= same;
  });
}

bool is_cut(const graph::CandidateLayout& layout, int node) { return layout.graph().nodes[node].kind == NodeKind::cut; }

}  // namespace

int continue_lines(RegionLayouts& regions, bool with_cuts) {
  const CadFace& face = regions.face;
  const double same = relative_same * face.diameter;
  std::vector<std::vector<LineKind>> kinds = kinds_of_lines(regions);
  int num_lines = 0;
  for (const InterfaceChain& chain : interface_chains(regions))
    for (const int side : {0, 1})
      for (const Station& station : chain.stations[side]) {
        if (has_station_at(chain, 1 - side, station.position, same)) continue;
        if (!with_cuts && is_cut(regions.layouts[station.region], station.node)) continue;
        Place place = place_on_side(face, chain, 1 - side, regions.place_of(station.region, station.node));
        const int region = regions.region_of_curve(place.curve);
        place.curve -= regions.first_curves[region];
        num_lines += insert_line(regions.layouts[region], *regions.fields[region], place);
      }
  renew_lines(regions, std::move(kinds), LineKind::traced);
  return num_lines;
}

int remove_needless_cuts(RegionLayouts& regions) {
  int num_removed = 0;
  std::vector<std::vector<LineKind>> kinds = kinds_of_lines(regions);
  for (graph::CandidateLayout& layout : regions.layouts) {
    graph::Subdivision& subdivision = layout.subdivision;
    for (int a = 0; a < subdivision.arc_bound(); ++a) {
      if (!subdivision.has_arc(a)) continue;
      const int from = subdivision.start({a}), to = subdivision.end({a});
      // The other end of a cut is a line end like others.
      const bool is_single = subdivision.around(from).size() == 3 && subdivision.around(to).size() == 3;
      if (!is_single || !is_cut(layout, from) || layout.graph().nodes[to].curve < 0 ||
          layout.graph().arcs[a].is_boundary || !subdivision.remove_arc(a))
        continue;
      for (const int node : {from, to}) subdivision.dissolve_node(node);
      ++num_removed;
    }
    subdivision.compact();
  }
  renew_lines(regions, std::move(kinds), LineKind::traced);
  return num_removed;
}

}  // namespace quadrille::couple
