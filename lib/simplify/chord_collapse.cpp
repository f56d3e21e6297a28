#include "simplify/chord_collapse.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "graph/chord_pieces.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {
namespace {

// Blocks from a pin to the next one on the other side.
struct Stretch {
  int first_rung = 0, num_blocks = 0;
  bool from_left = true;
};

class Collapser {
 public:
  Collapser(const SeparatrixGraph& graph, const graph::ChordStrip& strip, const std::vector<graph::Pin>& pins)
      : old_(graph),
        strip_(strip),
        table_(graph.face, graph.splines),
        sides_(pins),
        kept_(strip.num_blocks(), graph::Pin::none),
        pins_(pins) {
    choose_sides();
  }

  std::optional<std::vector<Blend>> blends(const field::FieldEvaluator& evaluator, const BlendOptions& options) const {
    if (drops_boundary()) return std::nullopt;
    std::vector<Blend> found;
    for (const Stretch& s : stretches_) {
      auto blend = make_blend(evaluator, table_, rail(s, s.from_left), rail(s, !s.from_left), options);
      if (!blend) return std::nullopt;
      found.push_back(std::move(*blend));
    }
    return found;
  }

  std::optional<Collapse> run(const std::vector<Blend>& blends) {
    if (drops_boundary()) return std::nullopt;
    result_.graph = old_;
    kinds_ = spline_kinds(old_);
    weld_nodes_.resize(strip_.rungs.size());
    new_arcs_.resize(strip_.num_blocks());
    for (const Stretch& s : stretches_) {
      auto spline = find_blend(blends, rail(s, s.from_left), rail(s, !s.from_left));
      if (!spline || !place(s, std::move(*spline))) return std::nullopt;
    }
    changed_.assign(old_.arcs.size(), false);
    for (int i = 0; i < num_rungs(); ++i) weld(i);
    rebuild_arcs();
    drop_lone_nodes();
    result_.graph.lines = lines_of_arcs(result_.graph, kinds_);
    return std::move(result_);
  }

 private:
  int num_rungs() const { return static_cast<int>(strip_.rungs.size()); }
  int wrap(int rung) const { return strip_.is_closed ? rung % num_rungs() : rung; }

  // Which rail each block keeps, and where the rails are blended.
  void choose_sides() {
    int first = 0;
    while (pins_[first] == graph::Pin::none) ++first;
    if (!strip_.is_closed) {
      for (int b = 0; b < first; ++b) kept_[b] = sides_[b] = pins_[first];
    }
    const int end = strip_.is_closed ? first + num_rungs() : num_rungs();
    for (int i = first; i < end;) {
      int next = i + 1;
      while (next < end && pins_[wrap(next)] == graph::Pin::none) ++next;
      const bool is_last = !strip_.is_closed && next == end;
      const graph::Pin here = pins_[wrap(i)], there = is_last ? here : pins_[wrap(next)];
      if (here == there) {
        for (int k = i; k < next; ++k) {
          sides_[wrap(k)] = here;
          if (k < next - (is_last ? 1 : 0)) kept_[wrap(k)] = here;
        }
      } else {
        stretches_.push_back({i, next - i, here == graph::Pin::left});
      }
      i = next;
    }
  }

  bool drops_boundary() const {
    const auto is_boundary = [&](HalfEdge h) { return old_.arcs[h.arc].is_boundary; };
    for (int b = 0; b < strip_.num_blocks(); ++b)
      if ((kept_[b] != graph::Pin::left && is_boundary(strip_.left[b])) ||
          (kept_[b] != graph::Pin::right && is_boundary(strip_.right[b])))
        return true;
    return false;
  }

  graph::Pieces rail(const Stretch& stretch, bool is_left) const {
    graph::Pieces pieces;
    for (int k = 0; k < stretch.num_blocks; ++k) {
      const int block = wrap(stretch.first_rung + k);
      pieces =
          graph::joined(std::move(pieces), graph::pieces_along(old_, (is_left ? strip_.left : strip_.right)[block]));
    }
    return pieces;
  }

  // Where the blended line crosses the rungs are the new nodes, between them the new arcs.
  bool place(const Stretch& stretch, Nurbs spline) {
    std::vector<double> s{spline.begin()};
    for (int k = 1; k < stretch.num_blocks; ++k) {
      const int i = wrap(stretch.first_rung + k);
      const curve::Chain rung(table_, graph::pieces_along(old_, strip_.rungs[i]));
      const double share = static_cast<double>(k) / stretch.num_blocks;
      double at = spline.begin() + share * (spline.end() - spline.begin()), fraction = 0.5;
      if (!cross_chain(spline, rung, at, fraction) || at <= s.back()) return false;
      s.push_back(at);
      weld_nodes_[i] = rung.at(fraction);
    }
    s.push_back(spline.end());
    const int curve = result_.graph.face.num_curves() + static_cast<int>(result_.graph.splines.size());
    for (int k = 0; k < stretch.num_blocks; ++k)
      new_arcs_[wrap(stretch.first_rung + k)] = ArcPiece{curve, s[k], s[k + 1]};
    result_.graph.splines.push_back(std::move(spline));
    kinds_.emplace_back("merged");
    return true;
  }

  void weld(int i) {
    const int l = start_of(old_.arcs, strip_.rungs[i]), r = end_of(old_.arcs, strip_.rungs[i]);
    const graph::Pieces rung = graph::pieces_along(old_, strip_.rungs[i]);
    if (weld_nodes_[i]) {
      const auto [before, behind] = graph::cut(rung, *weld_nodes_[i]);
      result_.graph.nodes[l].position = weld_nodes_[i]->position;
      node_of_[r] = l;
      lengthen(l, graph::reversed_pieces(before));
      lengthen(r, behind);
    } else if (sides_[i] == graph::Pin::left) {
      node_of_[r] = l;
      lengthen(r, rung);
    } else {
      node_of_[l] = r;
      lengthen(l, graph::reversed_pieces(rung));
    }
  }

  // The one arc that leaves the strip at a regular node gets `pieces` in front of it.
  void lengthen(int node, const graph::Pieces& pieces) {
    for (int a = 0; a < static_cast<int>(old_.arcs.size()); ++a)
      for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}}) {
        if (start_of(old_.arcs, h) != node || is_of_strip(a)) continue;
        graph::Pieces& own = result_.graph.arcs[a].pieces;
        own = !h.is_backwards ? graph::joined(pieces, own)
                              : graph::joined(std::move(own), graph::reversed_pieces(pieces));
        changed_[a] = true;
      }
  }

  bool is_of_strip(int arc) const {
    const auto has = [&](const std::vector<HalfEdge>& half_edges) {
      return std::any_of(half_edges.begin(), half_edges.end(), [&](HalfEdge d) { return d.arc == arc; });
    };
    return has(strip_.rungs) || has(strip_.left) || has(strip_.right);
  }

  int welded(int node) const {
    const auto found = node_of_.find(node);
    return found == node_of_.end() ? node : found->second;
  }

  void rebuild_arcs() {
    std::vector<int> stays_as(old_.arcs.size(), -2);  // -2: as it is, -1: goes, else: the rail that it becomes
    for (const HalfEdge d : strip_.rungs) stays_as[d.arc] = -1;
    for (int b = 0; b < strip_.num_blocks(); ++b) {
      const int left = strip_.left[b].arc, right = strip_.right[b].arc;
      const bool keeps_left = kept_[b] != graph::Pin::right;
      stays_as[keeps_left ? right : left] = keeps_left ? left : right;
      if (kept_[b] != graph::Pin::none) continue;
      GraphArc& arc = result_.graph.arcs[left];
      arc = {start_of(old_.arcs, strip_.left[b]), end_of(old_.arcs, strip_.left[b]), false, 0, {*new_arcs_[b]}};
      changed_[left] = true;
    }
    std::vector<GraphArc> arcs;
    result_.arc2arc.assign(old_.arcs.size(), -1);
    for (std::size_t a = 0; a < old_.arcs.size(); ++a) {
      if (stays_as[a] != -2) continue;
      GraphArc arc = std::move(result_.graph.arcs[a]);
      arc.from = welded(arc.from), arc.to = welded(arc.to);
      result_.arc2arc[a] = static_cast<int>(arcs.size());
      arcs.push_back(std::move(arc));
      result_.is_changed.push_back(changed_[a]);
    }
    for (std::size_t a = 0; a < old_.arcs.size(); ++a)
      if (stays_as[a] >= 0) result_.arc2arc[a] = result_.arc2arc[stays_as[a]];
    result_.graph.arcs = std::move(arcs);
  }

  void drop_lone_nodes() {
    SeparatrixGraph& graph = result_.graph;
    std::vector<int> number(graph.nodes.size(), -1);
    std::vector<GraphNode> nodes;
    for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n) {
      if (node_of_.count(n) > 0) continue;
      number[n] = static_cast<int>(nodes.size());
      nodes.push_back(graph.nodes[n]);
    }
    for (GraphArc& arc : graph.arcs) arc.from = number[arc.from], arc.to = number[arc.to];
    graph.nodes = std::move(nodes);
  }

  const SeparatrixGraph& old_;
  const graph::ChordStrip& strip_;
  curve::CurveTable table_;
  std::vector<graph::Pin> sides_;  // of rungs that no blend crosses: the end that stays
  std::vector<graph::Pin> kept_;   // of blocks: the rail that stays
  const std::vector<graph::Pin>& pins_;
  std::vector<Stretch> stretches_;
  std::vector<std::optional<curve::ChainPoint>> weld_nodes_;  // of rungs that a blend crosses
  std::vector<std::optional<ArcPiece>> new_arcs_;             // of blocks
  std::map<int, int> node_of_;                                // where removed nodes went
  std::vector<bool> changed_;
  std::vector<std::string> kinds_;
  Collapse result_;
};

}  // namespace

std::optional<std::vector<Blend>> blends_of(const field::FieldEvaluator& evaluator, const SeparatrixGraph& graph,
                                            const graph::ChordStrip& strip, const std::vector<graph::Pin>& pins,
                                            const BlendOptions& options) {
  return Collapser(graph, strip, pins).blends(evaluator, options);
}

std::optional<Collapse> collapse_strip(const SeparatrixGraph& graph, const graph::ChordStrip& strip,
                                       const std::vector<graph::Pin>& pins, const std::vector<Blend>& blends) {
  return Collapser(graph, strip, pins).run(blends);
}

std::vector<std::string> spline_kinds(const SeparatrixGraph& graph) {
  std::vector<std::string> kinds(graph.splines.size(), "traced");
  for (const SeparatrixLine& line : graph.lines)
    for (const int arc : line.arcs)
      for (const ArcPiece& p : graph.arcs[arc].pieces) kinds[p.curve - graph.face.num_curves()] = line.kind;
  return kinds;
}

std::vector<SeparatrixLine> lines_of_arcs(const SeparatrixGraph& graph, const std::vector<std::string>& kinds) {
  std::vector<std::vector<int>> arcs_of(graph.splines.size());
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    if (!graph.arcs[a].is_boundary) arcs_of[graph.arcs[a].pieces.front().curve - graph.face.num_curves()].push_back(a);
  const auto low = [&](int a) { return std::min(graph.arcs[a].pieces.front().t0, graph.arcs[a].pieces.back().t1); };
  std::vector<SeparatrixLine> lines;
  for (std::size_t i = 0; i < arcs_of.size(); ++i) {
    std::sort(arcs_of[i].begin(), arcs_of[i].end(), [&](int a, int b) { return low(a) < low(b); });
    for (const int a : arcs_of[i]) {
      const GraphArc& arc = graph.arcs[a];
      const bool rises = arc.pieces.front().t0 < arc.pieces.front().t1;
      const int from = rises ? arc.from : arc.to, to = rises ? arc.to : arc.from;
      if (a == arcs_of[i].front() || lines.back().end != from) lines.push_back({from, from, kinds[i], {}});
      lines.back().end = to;
      lines.back().arcs.push_back(a);
    }
  }
  return lines;
}

void drop_unused_splines(SeparatrixGraph& graph) {
  const int first = graph.face.num_curves();
  std::vector<int> number(graph.splines.size(), -1);
  for (const GraphArc& arc : graph.arcs)
    for (const ArcPiece& p : arc.pieces)
      if (p.curve >= first) number[p.curve - first] = 0;
  std::vector<Nurbs> splines;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = first + static_cast<int>(splines.size());
    splines.push_back(std::move(graph.splines[i]));
  }
  for (GraphArc& arc : graph.arcs)
    for (ArcPiece& p : arc.pieces)
      if (p.curve >= first) p.curve = number[p.curve - first];
  graph.splines = std::move(splines);
}

}  // namespace quadrille::simplify
