#include "graph/chord_strip.hpp"

#include <algorithm>
#include <set>

#include "model/interfaces.hpp"

namespace quadrille::graph {
namespace {

// From a rung forwards to the boundary, the same rung or a block that was visited before.
ChordStrip follow(const Subdivision& subdivision, HalfEdge rung) {
  ChordStrip strip;
  strip.rungs.push_back(rung);
  std::set<int> met;
  for (HalfEdge h = rung; subdivision.face(h) >= 0;) {
    if (!met.insert(subdivision.face(h)).second) {
      strip.crosses_itself = true;
      break;
    }
    const HalfEdge right = subdivision.next(h), opposite = subdivision.next(right), left = subdivision.next(opposite);
    strip.blocks.push_back(subdivision.face(h));
    strip.left.push_back(left.reversed());
    strip.right.push_back(right);
    h = opposite.reversed();
    if (h == rung) {
      strip.is_closed = true;
      break;
    }
    strip.rungs.push_back(h);
  }
  return strip;
}

double mean_length(const std::vector<double>& lengths, const std::vector<HalfEdge>& half_edges) {
  double sum = 0;
  for (const HalfEdge h : half_edges) sum += lengths[h.arc];
  return sum / static_cast<double>(half_edges.size());
}

void measure(const std::vector<double>& lengths, ChordStrip& strip) {
  strip.width = mean_length(lengths, strip.rungs);
  if (strip.blocks.empty()) return;
  strip.length = strip.num_blocks() * (mean_length(lengths, strip.left) + mean_length(lengths, strip.right)) / 2;
}

bool repeats_a_node(const Subdivision& subdivision, const ChordStrip& strip) {
  std::set<int> nodes;
  for (const HalfEdge h : strip.rungs)
    if (!nodes.insert(subdivision.start(h)).second || !nodes.insert(subdivision.end(h)).second) return true;
  return false;
}

// False if the rung cannot be shrunk to a point.
bool find_fixed_side(const Subdivision& subdivision, HalfEdge rung, FixedSide& side) {
  const ArcGraph& graph = subdivision.graph();
  const GraphNode &l = graph.nodes[subdivision.start(rung)], &r = graph.nodes[subdivision.end(rung)];
  const bool is_inner = !is_on_cad_curve(graph, graph.arcs[rung.arc]);
  const bool left = is_fixed(l) || (is_inner && l.curve >= 0), right = is_fixed(r) || (is_inner && r.curve >= 0);
  side = left ? FixedSide::left : right ? FixedSide::right : FixedSide::none;
  return !(left && right);
}

}  // namespace

double arc_length(const curve::CurveTable& table, const GraphArc& arc) {
  double sum = 0;
  for (const ArcPiece& p : arc.pieces) sum += curve::Chain(table, {p}).length();
  return sum;
}

std::vector<double> arc_lengths(const ArcGraph& graph) {
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<double> lengths;
  lengths.reserve(graph.arcs.size());
  for (const GraphArc& arc : graph.arcs) lengths.push_back(arc_length(table, arc));
  return lengths;
}

ChordStrip strip_through(const Subdivision& subdivision, int arc) {
  ChordStrip strip = follow(subdivision, {arc});
  if (strip.is_closed || strip.crosses_itself) return strip;
  // An open strip is followed again from one of its ends.
  const ChordStrip back = follow(subdivision, {arc, true});
  const HalfEdge first = back.rungs.back().reversed(), last = strip.rungs.back();
  return follow(subdivision, first.arc <= last.arc ? first : last.reversed());
}

ChordStrip measured_strip(const Subdivision& subdivision, int arc, const std::vector<double>& lengths) {
  ChordStrip strip = strip_through(subdivision, arc);
  measure(lengths, strip);
  return strip;
}

std::vector<ChordStrip> all_strips(const Subdivision& subdivision, const std::vector<double>& lengths) {
  std::vector<bool> seen(subdivision.arc_bound(), false);
  std::vector<ChordStrip> strips;
  for (int arc = 0; arc < subdivision.arc_bound(); ++arc) {
    if (seen[arc] || !subdivision.has_arc(arc)) continue;
    strips.push_back(measured_strip(subdivision, arc, lengths));
    seen[arc] = true;
    for (const HalfEdge h : strips.back().rungs) seen[h.arc] = true;
  }
  return strips;
}

bool is_fixed(const GraphNode& node) {
  if (node.kind == NodeKind::corner || node.kind == NodeKind::junction) return true;
  return node.valence != (node.is_inner() ? 4 : 2);
}

std::vector<FixedSide> fixed_sides(const Subdivision& subdivision, const ChordStrip& strip) {
  if (strip.crosses_itself || strip.blocks.empty() || repeats_a_node(subdivision, strip)) return {};
  std::vector<FixedSide> sides(strip.rungs.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (!find_fixed_side(subdivision, strip.rungs[i], sides[i])) return {};
  const bool any = std::any_of(sides.begin(), sides.end(), [](FixedSide s) { return s != FixedSide::none; });
  return any ? sides : std::vector<FixedSide>{};
}

bool ends_on_periodic_side(const Subdivision& subdivision, const ChordStrip& strip) {
  const ArcGraph& graph = subdivision.graph();
  return std::any_of(strip.rungs.begin(), strip.rungs.end(), [&](HalfEdge h) {
    if (!graph.arcs[h.arc].is_boundary) return false;
    const int curve = graph.arcs[h.arc].pieces.front().curve;
    return std::any_of(graph.face.periodic_pairs.begin(), graph.face.periodic_pairs.end(),
                       [&](const PeriodicPair& pair) { return pair.curves[0] == curve || pair.curves[1] == curve; });
  });
}

}  // namespace quadrille::graph
