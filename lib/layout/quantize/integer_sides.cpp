#include "quantize/integer_sides.hpp"

#include "base/error.hpp"

namespace quadrille::quantize {

IntegerSides::IntegerSides(const std::vector<TFace>& faces, const std::vector<int>& lengths)
    : faces_(faces), lengths_(lengths), positions_(2 * lengths.size()) {
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    totals_.push_back({});
    for (int side = 0; side < 4; ++side)
      for (const HalfEdge h : faces[f][side]) {
        positions_[h.index()] = {f, side, totals_[f][side]};
        totals_[f][side] += lengths[h.arc];
      }
  }
}

std::pair<HalfEdge, int> IntegerSides::half_edge_at(int face, int side, int position) const {
  for (const HalfEdge h : faces_[face][side]) {
    const int length = lengths_[h.arc];
    if (position <= length) return {h, position};
    position -= length;
  }
  throw Defect("IntegerSides: a position beyond the end of a side");
}

}  // namespace quadrille::quantize
