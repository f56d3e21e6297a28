#include "couple/side_pairs.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "curve/arc_length.hpp"
#include "curve/chain.hpp"
#include "graph/separatrix_lines.hpp"
#include "model/periodic.hpp"

namespace quadrille::couple {
namespace {

using CurvePair = std::array<int, 2>;  // opposite curves of the first and the second side

/// Joins pairs of curves that continue each other on both sides.
class SideChains {
 public:
  SideChains(const CadFace& face, const curve::CurveTable& lengths, const std::vector<CurvePair>& pairs)
      : face_(face), lengths_(lengths), second_(face.num_curves(), -1), is_used_(face.num_curves(), false) {
    for (const auto& [first, second] : pairs) second_[first] = second;
  }

  /// First those that begin where no other ends, then closed ones.
  std::vector<SidePair> all(const std::vector<CurvePair>& pairs) {
    std::vector<SidePair> chains;
    for (const bool is_closed : {false, true})
      for (const CurvePair& pair : pairs)
        if (!is_used_[pair[0]] && (is_closed || !continues(face_.previous_in_loop(pair[0]))))
          chains.push_back(chain_from(pair[0]));
    return chains;
  }

 private:
  bool continues(int curve) const {
    const int next = face_.next_in_loop(curve);
    return second_[curve] >= 0 && second_[next] >= 0 && face_.next_in_loop(second_[next]) == second_[curve];
  }

  SidePair chain_from(int first) {
    SidePair chain;
    chain.offsets.push_back(0);
    for (int curve = first;; curve = face_.next_in_loop(curve)) {
      chain.curves[0].push_back(curve);
      chain.curves[1].push_back(second_[curve]);
      chain.offsets.push_back(chain.offsets.back() + lengths_.arc_length(curve).total());
      is_used_[curve] = true;
      if (!continues(curve)) return chain;
      chain.is_closed = face_.next_in_loop(curve) == first;
      if (chain.is_closed) return chain;
    }
  }

  const CadFace& face_;
  const curve::CurveTable& lengths_;
  std::vector<int> second_;  // by curve of a first side; else -1
  std::vector<bool> is_used_;
};

int index_of(const std::vector<int>& curves, int curve) {
  const auto found = std::find(curves.begin(), curves.end(), curve);
  return found == curves.end() ? -1 : static_cast<int>(found - curves.begin());
}

// The last arc of the regular line that ends at the node; -1: it is another node.
int line_at(const graph::CandidateLayout& layout, int node) {
  const GraphNode& n = layout.graph().nodes[node];
  const std::vector<HalfEdge> around = layout.subdivision.around(node);
  const bool is_line_end = n.kind == NodeKind::boundary || n.kind == NodeKind::cut;
  return is_line_end && n.valence == 2 && around.size() == 3 ? around[1].arc : -1;
}

/// Adds the nodes of one layout to the sides on which they lie.
class SideNodes {
 public:
  /// `lengths`: of the curves of the whole.
  SideNodes(const RegionLayouts& layouts, const curve::CurveTable& lengths, int number)
      : layouts_(layouts),
        lengths_(lengths),
        number_(number),
        layout_(layouts.layouts[number]),
        table_(layout_.graph().face, layout_.graph().splines),
        kinds_(graph::spline_kinds(layout_.graph(), layout_.lines)) {}

  void add_to(SidePair& pair, CutEnds cuts) const {
    const std::vector<GraphNode>& nodes = layout_.graph().nodes;
    for (int n = 0; n < static_cast<int>(nodes.size()); ++n) {
      if (nodes[n].curve < 0) continue;
      const BoundaryPoint point = layouts_.point_of(number_, n);
      for (const int side : {0, 1}) {
        const int k = index_of(pair.curves[side], point.curve);
        if (k < 0) continue;
        double position = position_on(pair, k, point);
        if (!pair.is_closed && (position <= 0 || position >= pair.length())) continue;
        if (position >= pair.length()) position = 0;
        const SideNode node = side_node(n, position);
        if (!node.is_cut || cuts == CutEnds::included) pair.nodes[side].push_back(node);
      }
    }
  }

 private:
  double position_on(const SidePair& pair, int k, const BoundaryPoint& point) const {
    const int first = pair.curves[0][k];
    const double t = point.curve == first ? point.t : periodic_parameter(layouts_.face, point.curve, point.t, first);
    return pair.offsets[k] + lengths_.arc_length(first).at(t);
  }

  SideNode side_node(int node, double position) const {
    SideNode found{number_, node, position};
    const int line = line_at(layout_, node);
    if (line < 0) return found;
    const std::vector<ArcPiece>& pieces = layout_.graph().arcs[line].pieces;
    const int spline = pieces.front().curve - layout_.graph().face.num_curves();
    found.is_movable = true;
    found.line_length = curve::Chain(table_, pieces).length();
    found.is_cut = spline >= 0 && kinds_[spline] == LineKind::cut;
    return found;
  }

  const RegionLayouts& layouts_;
  const curve::CurveTable& lengths_;
  int number_;
  const graph::CandidateLayout& layout_;
  curve::CurveTable table_;
  std::vector<LineKind> kinds_;  // of the splines
};

std::vector<SidePair> sides(const RegionLayouts& layouts, const std::vector<CurvePair>& pairs, CutEnds cuts) {
  const std::vector<Nurbs> no_splines;
  const curve::CurveTable lengths(layouts.face, no_splines);
  std::vector<SidePair> chains = SideChains(layouts.face, lengths, pairs).all(pairs);
  for (int r = 0; r < static_cast<int>(layouts.layouts.size()) && !chains.empty(); ++r) {
    const SideNodes nodes(layouts, lengths, r);
    for (SidePair& chain : chains) nodes.add_to(chain, cuts);
  }
  for (SidePair& chain : chains)
    for (std::vector<SideNode>& side : chain.nodes)
      std::stable_sort(side.begin(), side.end(),
                       [](const SideNode& a, const SideNode& b) { return a.position < b.position; });
  return chains;
}

}  // namespace

std::vector<SidePair> interface_sides(const RegionLayouts& regions, CutEnds cuts) {
  const CadFace& face = regions.face;
  std::vector<CurvePair> pairs;
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.is_interface(c) && c < face.partners[c]) pairs.push_back({c, face.partners[c]});
  return sides(regions, pairs, cuts);
}

std::vector<SidePair> periodic_sides(const RegionLayouts& layouts) {
  std::vector<CurvePair> pairs;
  for (const PeriodicPair& pair : layouts.face.periodic_pairs) pairs.push_back({pair.curves[0], pair.curves[1]});
  return sides(layouts, pairs, CutEnds::included);
}

BoundaryPoint point_on_side(const CadFace& face, const SidePair& pair, int side, const BoundaryPoint& point) {
  if (index_of(pair.curves[side], point.curve) >= 0) return point;
  const int k = index_of(pair.curves[1 - side], point.curve);
  if (k < 0) throw Defect("couple: a point that is on neither of two sides has none opposite to it");
  return opposite_point(face, point, pair.curves[side][k]);
}

BoundaryPoint point_at(const CadFace& face, const SidePair& pair, double position) {
  std::size_t k = 0;
  while (k + 1 < pair.curves[0].size() && position >= pair.offsets[k + 1]) ++k;
  const int curve = pair.curves[0][k];
  return boundary_point(face, curve, curve::ArcLength(face.curves[curve]).parameter(position - pair.offsets[k]));
}

}  // namespace quadrille::couple
