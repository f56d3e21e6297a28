#include "quantize/clip_lines.hpp"

#include <utility>

#include "curve/nurbs.hpp"

namespace quadrille::quantize {
namespace {

std::vector<graph::FinishedLine> covered_pieces(const graph::FinishedLine& line, const CoveredPart& part) {
  if (part.is_whole()) return {line};
  std::vector<graph::FinishedLine> pieces;
  pieces.push_back({line.start, {}, curve::trimmed(line.spline, line.spline.begin(), part.first), line.kind});
  if (part.last < line.spline.end())
    pieces.push_back({{}, line.end, curve::trimmed(line.spline, part.last, line.spline.end()), line.kind});
  return pieces;
}

}  // namespace

ClippedLines clip_lines(const trace::LineArrangement& arrangement, const std::vector<CoveredPart>& covered) {
  ClippedLines clipped;
  std::vector<int> first_piece;  // of each line, and the end
  for (size_t i = 0; i < arrangement.lines.size(); ++i) {
    first_piece.push_back(static_cast<int>(clipped.pieces.size()));
    for (graph::FinishedLine& piece : covered_pieces(arrangement.lines[i].line, covered[i])) {
      clipped.pieces.push_back(std::move(piece));
      clipped.piece2line.push_back(static_cast<int>(i));
    }
  }
  first_piece.push_back(static_cast<int>(clipped.pieces.size()));
  const auto piece_at = [&](int line, double s) {
    for (int p = first_piece[line]; p < first_piece[line + 1]; ++p)
      if (s >= clipped.pieces[p].spline.begin() && s <= clipped.pieces[p].spline.end()) return p;
    return -1;
  };
  for (graph::Crossing c : arrangement.inner_crossings) {
    c.a = piece_at(c.a, c.s), c.b = piece_at(c.b, c.t);
    if (c.a >= 0 && c.b >= 0) clipped.crossings.push_back(c);
  }
  return clipped;
}

}  // namespace quadrille::quantize
