#include "graph/chord_strip.hpp"

#include <algorithm>
#include <set>

#include "curve/chain.hpp"

namespace quadrille::graph {
namespace {

// Where each half-edge stands: its cycle and its place there.
class SideTable {
 public:
  SideTable(const SeparatrixGraph& graph, const PlanarFaces& faces)
      : faces_(faces), face_(2, std::vector<int>(graph.arcs.size(), -1)), place_(face_) {
    for (int f = 0; f < static_cast<int>(faces.cycles.size()); ++f)
      for (int k = 0; k < static_cast<int>(faces.cycles[f].size()); ++k) {
        const HalfEdge h = faces.cycles[f][k];
        at(face_, h) = f;
        at(place_, h) = k;
      }
  }

  /// The block on a half-edge's left, or -1.
  int face(HalfEdge h) { return at(face_, h); }
  /// The half-edge `turns` sides counter-clockwise after this one in the block on its left.
  HalfEdge side(HalfEdge h, int turns) { return faces_.cycles[face(h)][(at(place_, h) + turns) % 4]; }

 private:
  using Table = std::vector<std::vector<int>>;
  static int& at(Table& table, HalfEdge h) { return table[h.is_backwards][h.arc]; }

  const PlanarFaces& faces_;
  Table face_, place_;
};

// From a rung forwards until the boundary, the same rung or a block met before.
ChordStrip walk(SideTable& sides, HalfEdge rung) {
  ChordStrip strip;
  strip.rungs.push_back(rung);
  std::set<int> met;
  for (HalfEdge d = rung; sides.face(d) >= 0;) {
    if (!met.insert(sides.face(d)).second) {
      strip.crosses_itself = true;
      break;
    }
    strip.blocks.push_back(sides.face(d));
    strip.left.push_back(sides.side(d, 3).reversed());
    strip.right.push_back(sides.side(d, 1));
    d = sides.side(d, 2).reversed();
    if (d == rung) {
      strip.is_closed = true;
      break;
    }
    strip.rungs.push_back(d);
  }
  return strip;
}

ChordStrip strip_from(SideTable& sides, int arc) {
  ChordStrip strip = walk(sides, {arc});
  if (strip.is_closed || strip.crosses_itself) return strip;
  // Open: once more from one end.
  const ChordStrip back = walk(sides, {arc, true});
  const HalfEdge first = back.rungs.back().reversed(), last = strip.rungs.back();
  return walk(sides, first.arc <= last.arc ? first : last.reversed());
}

double mean_length(const std::vector<double>& lengths, const std::vector<HalfEdge>& half_edges) {
  double sum = 0;
  for (const HalfEdge d : half_edges) sum += lengths[d.arc];
  return sum / static_cast<double>(half_edges.size());
}

void measure(const std::vector<double>& lengths, ChordStrip& strip) {
  strip.width = mean_length(lengths, strip.rungs);
  if (strip.blocks.empty()) return;
  strip.length = strip.num_blocks() * (mean_length(lengths, strip.left) + mean_length(lengths, strip.right)) / 2;
}

}  // namespace

std::vector<double> arc_lengths(const SeparatrixGraph& graph, PieceLengths& pieces) {
  const curve::CurveTable table(graph.face, graph.splines);
  std::vector<double> lengths;
  lengths.reserve(graph.arcs.size());
  for (const GraphArc& arc : graph.arcs) {
    double sum = 0;
    for (const ArcPiece& p : arc.pieces) {
      const auto [at, is_new] = pieces.known.try_emplace({p.curve, p.t0, p.t1}, 0);
      if (is_new) at->second = curve::Chain(table, {p}).length();
      sum += at->second;
    }
    lengths.push_back(sum);
  }
  return lengths;
}

std::vector<double> arc_lengths(const SeparatrixGraph& graph) {
  PieceLengths pieces;
  return arc_lengths(graph, pieces);
}

ChordStrip strip_through(const SeparatrixGraph& graph, const PlanarFaces& faces, int arc) {
  SideTable sides(graph, faces);
  return strip_from(sides, arc);
}

std::vector<ChordStrip> all_strips(const SeparatrixGraph& graph, const PlanarFaces& faces,
                                   const std::vector<double>& lengths) {
  SideTable sides(graph, faces);
  std::vector<bool> seen(graph.arcs.size(), false);
  std::vector<ChordStrip> strips;
  for (int arc = 0; arc < static_cast<int>(graph.arcs.size()); ++arc) {
    if (seen[arc]) continue;
    strips.push_back(strip_from(sides, arc));
    seen[arc] = true;
    for (const HalfEdge d : strips.back().rungs) seen[d.arc] = true;
    measure(lengths, strips.back());
  }
  return strips;
}

bool is_fixed(const GraphNode& node) {
  return node.curve < 0 ? node.valence != 4 : node.kind == NodeKind::corner || node.valence != 2;
}

namespace {

bool repeats_a_node(const SeparatrixGraph& graph, const ChordStrip& strip) {
  std::set<int> nodes;
  for (const HalfEdge d : strip.rungs)
    if (!nodes.insert(start_of(graph.arcs, d)).second || !nodes.insert(end_of(graph.arcs, d)).second) return true;
  return false;
}

// False where the rung cannot be welded.
bool find_pin(const SeparatrixGraph& graph, HalfEdge rung, Pin& pin) {
  const GraphNode &l = graph.nodes[start_of(graph.arcs, rung)], &r = graph.nodes[end_of(graph.arcs, rung)];
  const bool is_inner = !graph.arcs[rung.arc].is_boundary;
  const bool left = is_fixed(l) || (is_inner && l.curve >= 0), right = is_fixed(r) || (is_inner && r.curve >= 0);
  pin = left ? Pin::left : right ? Pin::right : Pin::none;
  return !(left && right);
}

}  // namespace

std::vector<Pin> pins_of(const SeparatrixGraph& graph, const ChordStrip& strip) {
  if (strip.crosses_itself || strip.blocks.empty() || repeats_a_node(graph, strip)) return {};
  std::vector<Pin> pins(strip.rungs.size());
  for (std::size_t i = 0; i < pins.size(); ++i)
    if (!find_pin(graph, strip.rungs[i], pins[i])) return {};
  const bool any = std::any_of(pins.begin(), pins.end(), [](Pin p) { return p != Pin::none; });
  return any ? pins : std::vector<Pin>{};
}

}  // namespace quadrille::graph
