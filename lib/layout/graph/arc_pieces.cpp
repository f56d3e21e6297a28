#include "graph/arc_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::graph {

Pieces reversed_pieces(Pieces pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (ArcPiece& p : pieces) std::swap(p.t0, p.t1);
  return pieces;
}

Pieces pieces_along(const ArcGraph& graph, HalfEdge h) {
  const Pieces& pieces = graph.arcs[h.arc].pieces;
  return h.is_backwards ? reversed_pieces(pieces) : pieces;
}

Pieces joined(Pieces first, const Pieces& second) {
  for (const ArcPiece& p : second) {
    if (!first.empty()) {
      ArcPiece& last = first.back();
      const bool goes_on = last.curve == p.curve && (last.t1 > last.t0) == (p.t1 > p.t0) &&
                           std::abs(last.t1 - p.t0) <= 1e-9 * std::abs(p.t1 - p.t0);
      if (goes_on) {
        last.t1 = p.t1;
        continue;
      }
    }
    first.push_back(p);
  }
  return first;
}

std::pair<Pieces, Pieces> cut(const Pieces& pieces, const curve::ChainPoint& at) {
  Pieces before(pieces.begin(), pieces.begin() + at.piece + 1), behind(pieces.begin() + at.piece, pieces.end());
  before.back().t1 = at.t;
  behind.front().t0 = at.t;
  if (before.size() > 1 && before.back().t0 == at.t) before.pop_back();
  if (behind.size() > 1 && behind.front().t1 == at.t) behind.erase(behind.begin());
  return {before, behind};
}

}  // namespace quadrille::graph
