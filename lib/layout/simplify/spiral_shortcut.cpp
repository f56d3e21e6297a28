#include "simplify/spiral_shortcut.hpp"

#include <set>
#include <utility>

#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "model/interfaces.hpp"

namespace quadrille::simplify {
namespace {

using graph::ChordStrip;
using graph::FixedSide;
using graph::Subdivision;

// The spline that an inner arc is a part of, -1 on the boundary and on interfaces.
int spline_of(const ArcGraph& graph, int a) {
  const GraphArc& arc = graph.arcs[a];
  return is_on_cad_curve(graph, arc) ? -1 : arc.pieces.front().curve - graph.face.num_curves();
}

FixedSide fixed_end(const Subdivision& subdivision, HalfEdge rung, bool& both) {
  const bool left = graph::is_fixed(subdivision.graph().nodes[subdivision.start(rung)]);
  const bool right = graph::is_fixed(subdivision.graph().nodes[subdivision.end(rung)]);
  both = left && right;
  return left ? FixedSide::left : right ? FixedSide::right : FixedSide::none;
}

// Rungs first .. last of a strip, if they are a shortcut.
std::optional<SpiralShortcut> shortcut_between(const ArcGraph& graph, const ChordStrip& strip, int first, int last,
                                               bool from_left, const std::vector<double>& lengths) {
  SpiralShortcut s;
  s.from_left = from_left;
  for (int i = first; i <= last; ++i) s.rungs.push_back(strip.rungs[i]);
  for (int i = first; i < last; ++i) s.left.push_back(strip.left[i]), s.right.push_back(strip.right[i]);
  const std::vector<HalfEdge>&from = from_left ? s.left : s.right, &to = from_left ? s.right : s.left;
  s.spline = spline_of(graph, from.front().arc);
  if (s.spline < 0) return std::nullopt;
  std::set<int> arcs;
  double width = 0, length = 0;
  for (const std::vector<HalfEdge>* rail : {&from, &to})
    for (const HalfEdge h : *rail) {
      if (spline_of(graph, h.arc) != s.spline || !arcs.insert(h.arc).second) return std::nullopt;
      length += lengths[h.arc] / 2;
    }
  for (const HalfEdge h : s.rungs) width += lengths[h.arc] / static_cast<double>(s.rungs.size());
  s.aspect = width / length;
  return s;
}

// From the fixed end of the first rung to the fixed end of the last, block by block; the rungs between are divided.
//
// The blend lies between the rungs and the rails that it replaces: at its two ends the whole sector remains on the side
// of the rung.
void insert_blend(Subdivision& subdivision, const SpiralShortcut& shortcut, const std::vector<RungCrossing>& crossings,
                  Nurbs spline) {
  const int last = static_cast<int>(shortcut.rungs.size()) - 1;
  const HalfEdge first_rung = shortcut.rungs.front(), last_rung = shortcut.rungs.back();
  Subdivision::Sector from = shortcut.from_left ? Subdivision::Sector{shortcut.left.front().reversed(), 0}
                                                : Subdivision::Sector{first_rung, subdivision.quarters(first_rung)};
  const Subdivision::Sector end =
      shortcut.from_left ? Subdivision::Sector{shortcut.right.back(), 0}
                         : Subdivision::Sector{last_rung.reversed(), subdivision.quarters(last_rung.reversed())};
  double s = spline.begin();
  const double s_end = spline.end();
  const int curve = subdivision.add_spline(std::move(spline));
  for (int i = 1; i < last; ++i) {
    const RungCrossing& crossing = crossings[i - 1];
    const Subdivision::Division divided = graph::divide_at_point(subdivision, shortcut.rungs[i], crossing.at);
    subdivision.insert_arc(from, {divided.second.reversed(), 1}, {{curve, s, crossing.s}});
    from = {divided.first, 1};
    s = crossing.s;
  }
  subdivision.insert_arc(from, end, {{curve, s, s_end}});
}

// Joins both arcs at a node, which are parts of one spline.
bool dissolve_crossing(Subdivision& subdivision, int node) {
  const std::vector<HalfEdge> arcs = subdivision.around(node);
  if (arcs.size() != 2) return false;
  const int spline = spline_of(subdivision.graph(), arcs[0].arc);
  return spline >= 0 && spline == spline_of(subdivision.graph(), arcs[1].arc) && subdivision.dissolve_node(node);
}

}  // namespace

std::vector<SpiralShortcut> find_shortcuts(const Subdivision& subdivision, const std::vector<double>& lengths) {
  std::vector<SpiralShortcut> found;
  for (const ChordStrip& strip : graph::all_strips(subdivision, lengths)) {
    int first = -1;
    FixedSide side = FixedSide::none;
    for (int i = 0; i < static_cast<int>(strip.rungs.size()); ++i) {
      bool both = false;
      const FixedSide here = fixed_end(subdivision, strip.rungs[i], both);
      if (both) first = -1;
      if (both || here == FixedSide::none) continue;
      if (first >= 0 && here != side)
        if (auto s = shortcut_between(subdivision.graph(), strip, first, i, side == FixedSide::left, lengths))
          found.push_back(*s);
      first = i, side = here;
    }
  }
  return found;
}

std::optional<Blend> blend_of(const field::FieldsOfRegions& fields, const ArcGraph& graph,
                              const SpiralShortcut& shortcut, const BlendOptions& options) {
  graph::Pieces left, right;
  for (const HalfEdge h : shortcut.left) left = graph::joined(std::move(left), graph::pieces_along(graph, h));
  for (const HalfEdge h : shortcut.right) right = graph::joined(std::move(right), graph::pieces_along(graph, h));
  const curve::CurveTable table(graph.face, graph.splines);
  return make_blend(fields, table, shortcut.from_left ? left : right, shortcut.from_left ? right : left, options);
}

std::optional<Subdivision> with_shortcut(Subdivision subdivision, const SpiralShortcut& shortcut, const Blend& blend) {
  const HalfEdge rung = shortcut.rungs.front();
  const int start = shortcut.from_left ? subdivision.start(rung) : subdivision.end(rung);
  const Vec2 at = subdivision.graph().nodes[start].position;
  const Vec2 begin = curve::point(blend.spline, blend.spline.begin());
  const Vec2 end = curve::point(blend.spline, blend.spline.end());
  Nurbs spline = distance(begin, at) <= distance(end, at) ? blend.spline : curve::reversed(blend.spline);
  std::set<int> removed, crossed;
  for (int a = 0; a < subdivision.arc_bound(); ++a) {
    if (spline_of(subdivision.graph(), a) != shortcut.spline) continue;
    removed.insert(a);
    for (const int n : {subdivision.graph().arcs[a].from, subdivision.graph().arcs[a].to})
      if (!graph::is_fixed(subdivision.graph().nodes[n])) crossed.insert(n);
  }
  for (const HalfEdge h : shortcut.rungs)
    if (removed.contains(h.arc)) return std::nullopt;  // the line crosses itself
  const std::vector<HalfEdge> inner(shortcut.rungs.begin() + 1, shortcut.rungs.end() - 1);
  const auto crossings = cross_rungs(subdivision.graph(), inner, spline);
  if (!crossings) return std::nullopt;
  insert_blend(subdivision, shortcut, *crossings, std::move(spline));
  for (const int a : removed)
    if (!subdivision.remove_arc(a)) return std::nullopt;
  for (const int n : crossed)
    if (!dissolve_crossing(subdivision, n)) return std::nullopt;
  subdivision.compact();
  return subdivision;
}

}  // namespace quadrille::simplify
