#include "simplify/chord_shortcut.hpp"

#include <algorithm>
#include <set>

#include "curve/nurbs.hpp"
#include "graph/chord_pieces.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {
namespace {

// The spline that an inner arc is a part of, -1 on the boundary.
int spline_of(const SeparatrixGraph& graph, HalfEdge h) {
  const GraphArc& arc = graph.arcs[h.arc];
  return arc.is_boundary ? -1 : arc.pieces.front().curve - graph.face.num_curves();
}

graph::Pin fixed_end(const SeparatrixGraph& graph, HalfEdge rung, bool& both) {
  const bool left = graph::is_fixed(graph.nodes[start_of(graph.arcs, rung)]),
             right = graph::is_fixed(graph.nodes[end_of(graph.arcs, rung)]);
  both = left && right;
  return left ? graph::Pin::left : right ? graph::Pin::right : graph::Pin::none;
}

// Rungs first .. last of a strip, if they are a shortcut.
std::optional<Shortcut> shortcut_between(const SeparatrixGraph& graph, const graph::ChordStrip& strip, int first,
                                         int last, bool from_left, const std::vector<double>& lengths) {
  Shortcut s;
  s.from_left = from_left;
  for (int i = first; i <= last; ++i) s.rungs.push_back(strip.rungs[i]);
  for (int i = first; i < last; ++i) s.left.push_back(strip.left[i]), s.right.push_back(strip.right[i]);
  const std::vector<HalfEdge>&from = from_left ? s.left : s.right, &to = from_left ? s.right : s.left;
  s.spline = spline_of(graph, from.front());
  if (s.spline < 0) return std::nullopt;
  std::set<int> arcs;
  double width = 0, length = 0;
  for (const std::vector<HalfEdge>* rail : {&from, &to})
    for (const HalfEdge d : *rail) {
      if (spline_of(graph, d) != s.spline || !arcs.insert(d.arc).second) return std::nullopt;
      length += lengths[d.arc] / 2;
    }
  for (const HalfEdge d : s.rungs) width += lengths[d.arc] / static_cast<double>(s.rungs.size());
  s.slimness = width / length;
  return s;
}

struct Editor {
  explicit Editor(const SeparatrixGraph& old) : graph(old), is_gone(old.arcs.size(), false) {}

  int add_arc(int from, int to, graph::Pieces pieces) {
    graph.arcs.push_back({from, to, false, 0, std::move(pieces)});
    is_gone.push_back(false);
    return static_cast<int>(graph.arcs.size()) - 1;
  }

  // Two arcs that meet in a node of no others become one. False where they are not two.
  bool dissolve(int node) {
    std::vector<HalfEdge> half_edges;
    for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
      for (const HalfEdge d : {HalfEdge{a}, HalfEdge{a, true}})
        if (!is_gone[a] && start_of(graph.arcs, d) == node) half_edges.push_back(d);
    if (half_edges.size() != 2 || half_edges[0].arc == half_edges[1].arc) return false;
    const HalfEdge in = half_edges[0].reversed(), out = half_edges[1];
    if (spline_of(graph, in) < 0 || spline_of(graph, in) != spline_of(graph, out)) return false;
    add_arc(start_of(graph.arcs, in), end_of(graph.arcs, out),
            graph::joined(graph::pieces_along(graph, in), graph::pieces_along(graph, out)));
    is_gone[in.arc] = is_gone[out.arc] = true;
    return true;
  }

  SeparatrixGraph without_the_gone() {
    SeparatrixGraph result = graph;
    result.arcs.clear();
    std::vector<int> number(graph.nodes.size(), -1);
    for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
      if (is_gone[a]) continue;
      result.arcs.push_back(graph.arcs[a]);
      number[graph.arcs[a].from] = number[graph.arcs[a].to] = 0;
    }
    result.nodes.clear();
    for (std::size_t n = 0; n < number.size(); ++n) {
      if (number[n] < 0) continue;
      number[n] = static_cast<int>(result.nodes.size());
      result.nodes.push_back(graph.nodes[n]);
    }
    for (GraphArc& arc : result.arcs) arc.from = number[arc.from], arc.to = number[arc.to];
    return result;
  }

  SeparatrixGraph graph;
  std::vector<bool> is_gone;
};

// Puts the blend in, splitting the rungs that it crosses.
bool insert_blend(Editor& edit, const curve::CurveTable& table, const Shortcut& shortcut, Nurbs spline) {
  const int last = static_cast<int>(shortcut.rungs.size()) - 1;
  const auto pinned = [&](int rung, bool is_left) {
    return is_left ? start_of(edit.graph.arcs, shortcut.rungs[rung]) : end_of(edit.graph.arcs, shortcut.rungs[rung]);
  };
  const int curve = edit.graph.face.num_curves() + static_cast<int>(edit.graph.splines.size());
  int node = pinned(0, shortcut.from_left);
  double s = spline.begin();
  for (int i = 1; i < last; ++i) {
    const HalfEdge rung = shortcut.rungs[i];
    const graph::Pieces pieces = graph::pieces_along(edit.graph, rung);
    const curve::Chain chain(table, pieces);
    double at = spline.begin() + (spline.end() - spline.begin()) * i / last, fraction = 0.5;
    if (!cross_chain(spline, chain, at, fraction) || at <= s) return false;
    const curve::ChainPoint x = chain.at(fraction);
    const int weld = static_cast<int>(edit.graph.nodes.size());
    edit.graph.nodes.push_back({x.position, NodeKind::crossing, 4, -1, 0});
    const auto [before, behind] = graph::cut(pieces, x);
    const int l = start_of(edit.graph.arcs, rung), r = end_of(edit.graph.arcs, rung);
    edit.is_gone[rung.arc] = true;
    edit.add_arc(l, weld, before);
    edit.add_arc(weld, r, behind);
    edit.add_arc(node, weld, {{curve, s, at}});
    node = weld, s = at;
  }
  edit.add_arc(node, pinned(last, !shortcut.from_left), {{curve, s, spline.end()}});
  edit.graph.splines.push_back(std::move(spline));
  return true;
}

}  // namespace

std::vector<Shortcut> find_shortcuts(const SeparatrixGraph& graph, const graph::PlanarFaces& faces,
                                     const std::vector<double>& lengths) {
  std::vector<Shortcut> found;
  for (const graph::ChordStrip& strip : graph::all_strips(graph, faces, lengths)) {
    int first = -1;
    graph::Pin side = graph::Pin::none;
    for (int i = 0; i < static_cast<int>(strip.rungs.size()); ++i) {
      bool both = false;
      const graph::Pin here = fixed_end(graph, strip.rungs[i], both);
      if (both) first = -1;
      if (both || here == graph::Pin::none) continue;
      if (first >= 0 && here != side)
        if (auto s = shortcut_between(graph, strip, first, i, side == graph::Pin::left, lengths)) found.push_back(*s);
      first = i, side = here;
    }
  }
  return found;
}

std::optional<Blend> blend_of(const field::FieldEvaluator& evaluator, const SeparatrixGraph& graph,
                              const Shortcut& shortcut, const BlendOptions& options) {
  graph::Pieces left, right;
  for (const HalfEdge d : shortcut.left) left = graph::joined(std::move(left), graph::pieces_along(graph, d));
  for (const HalfEdge d : shortcut.right) right = graph::joined(std::move(right), graph::pieces_along(graph, d));
  const curve::CurveTable table(graph.face, graph.splines);
  return make_blend(evaluator, table, shortcut.from_left ? left : right, shortcut.from_left ? right : left, options);
}

std::optional<SeparatrixGraph> take_shortcut(const SeparatrixGraph& graph, const Shortcut& shortcut,
                                             const Blend& blend) {
  const curve::CurveTable table(graph.face, graph.splines);
  const int first_rung = shortcut.rungs.front().arc;
  const int start = shortcut.from_left != shortcut.rungs.front().is_backwards ? graph.arcs[first_rung].from
                                                                              : graph.arcs[first_rung].to;
  const Vec2 begin = curve::point(blend.spline, blend.spline.begin()),
             end = curve::point(blend.spline, blend.spline.end());
  const Vec2 at = graph.nodes[start].position;
  Nurbs spline = distance(begin, at) <= distance(end, at) ? blend.spline : curve::reversed(blend.spline);
  std::vector<std::string> kinds = spline_kinds(graph);
  Editor edit(graph);
  std::set<int> crossed;
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    if (spline_of(graph, {a}) != shortcut.spline) continue;
    edit.is_gone[a] = true;
    for (const int n : {graph.arcs[a].from, graph.arcs[a].to})
      if (!graph::is_fixed(graph.nodes[n])) crossed.insert(n);
  }
  if (!insert_blend(edit, table, shortcut, std::move(spline))) return std::nullopt;
  for (const int n : crossed)
    if (!edit.dissolve(n)) return std::nullopt;
  SeparatrixGraph result = edit.without_the_gone();
  kinds.emplace_back("merged");
  result.lines = lines_of_arcs(result, kinds);
  return result;
}

}  // namespace quadrille::simplify
