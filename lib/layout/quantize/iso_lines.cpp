#include "quantize/iso_lines.hpp"

namespace quadrille::quantize {
namespace {

class Continuation {
 public:
  Continuation(const ArcGraph& t_mesh, const IntegerSides& sides) : sides_(sides) {
    result.crossings.resize(t_mesh.arcs.size());
    result.lines.resize(sides.faces().size());
  }

  // The line of a face through a position of a side; not at the side's ends.
  void start(int face, int side, int position) {
    const int direction = side % 2;
    const int offset = side < 2 ? position : sides_.total(face, direction) - position;
    if (result.lines[face][direction].insert(offset).second) unfinished_.push_back({face, direction, offset});
  }

  void finish() {
    while (!unfinished_.empty()) {
      const FaceLine line = unfinished_.back();
      unfinished_.pop_back();
      continue_beyond(line.face, line.direction, line.offset);
      continue_beyond(line.face, line.direction + 2, sides_.total(line.face, line.direction) - line.offset);
    }
  }

  IsoLines result;

 private:
  struct FaceLine {
    int face = 0, direction = 0, offset = 0;
  };

  // A line reaches a side: at a node it is the line of a T-junction there, elsewhere it crosses the arc.
  void continue_beyond(int face, int side, int position) {
    const auto [h, number] = sides_.half_edge_at(face, side, position);
    const int length = sides_.arc(h.arc);
    if (number == length) return;
    const bool is_new = result.crossings[h.arc].insert(!h.is_backwards ? number : length - number).second;
    const SidePosition& behind = sides_.position_of(h.reversed());
    if (!is_new || behind.face < 0) return;
    start(behind.face, behind.side, behind.offset + length - number);
  }

  const IntegerSides& sides_;
  std::vector<FaceLine> unfinished_;
};

}  // namespace

IsoLines iso_lines(const ArcGraph& t_mesh, const IntegerSides& sides) {
  Continuation continuation(t_mesh, sides);
  for (int f = 0; f < static_cast<int>(sides.faces().size()); ++f)
    for (int side = 0; side < 4; ++side) {
      const std::vector<HalfEdge>& half_edges = sides.faces()[f][side];
      for (size_t k = 1; k < half_edges.size(); ++k)  // T-junctions
        continuation.start(f, side, sides.position_of(half_edges[k]).offset);
    }
  continuation.finish();
  return std::move(continuation.result);
}

}  // namespace quadrille::quantize
