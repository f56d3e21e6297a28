#include "quantize/motorcycle_graph.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "curve/nurbs.hpp"

namespace quadrille::quantize {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A front reaches a crossing on its trail, number `side` of the two (0: Crossing::a, 1: b). Trail i has the front 2 i
/// and, from its other end, 2 i + 1.
struct Arrival {
  double time = 0;
  int front = 0, crossing = 0, side = 0;
};

// All arrivals if no front were stopped, by time.
std::vector<Arrival> arrivals_of(const std::vector<MotorcycleTrail>& trails,
                                 const std::vector<graph::Crossing>& crossings) {
  std::vector<Arrival> arrivals;
  for (int c = 0; c < static_cast<int>(crossings.size()); ++c)
    for (const int side : {0, 1}) {
      const int number = side == 0 ? crossings[c].a : crossings[c].b;
      const MotorcycleTrail& trail = trails[number];
      const double s = side == 0 ? crossings[c].s : crossings[c].t;
      arrivals.push_back({s - trail.head_start, 2 * number, c, side});
      if (trail.from_both_ends) arrivals.push_back({trail.length - s - trail.head_start, 2 * number + 1, c, side});
    }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const Arrival& a, const Arrival& b) { return a.time < b.time; });
  return arrivals;
}

std::vector<graph::FinishedLine> covered_pieces(const graph::FinishedLine& line, const CoveredPart& part) {
  if (part.is_whole()) return {line};
  std::vector<graph::FinishedLine> pieces;
  pieces.push_back({line.start, {}, curve::trimmed(line.spline, line.spline.begin(), part.first), line.kind});
  if (part.last < line.spline.end())
    pieces.push_back({{}, line.end, curve::trimmed(line.spline, part.last, line.spline.end()), line.kind});
  return pieces;
}

}  // namespace

std::vector<CoveredPart> trace_motorcycle_graph(const std::vector<MotorcycleTrail>& trails,
                                                const std::vector<graph::Crossing>& crossings, double tie) {
  std::vector<CoveredPart> covered;
  for (const MotorcycleTrail& trail : trails) covered.push_back({never, trail.length});
  std::vector<bool> is_stopped(2 * trails.size(), false);  // each front
  // When each of the two trails of a crossing reached it.
  std::vector<std::array<double, 2>> passed_at(crossings.size(), {never, never});
  std::set<std::pair<int, int>> tied;
  for (const Arrival& arrival : arrivals_of(trails, crossings)) {
    if (is_stopped[arrival.front]) continue;
    const graph::Crossing& c = crossings[arrival.crossing];
    const int trail = arrival.front / 2;
    double &here = passed_at[arrival.crossing][arrival.side], before = passed_at[arrival.crossing][1 - arrival.side];
    if (here < never) {  // by the front from the other end: they meet
      is_stopped[arrival.front] = true;
      covered[trail].first = never;
      continue;
    }
    here = arrival.time;
    const bool passes_tie = here - before <= tie && c.a != c.b;
    if (before == never || (passes_tie && tied.insert({c.a, c.b}).second)) continue;
    is_stopped[arrival.front] = true;
    const bool is_backwards = arrival.front % 2 == 1;
    (is_backwards ? covered[trail].last : covered[trail].first) = arrival.side == 0 ? c.s : c.t;
    if (!trails[trail].from_both_ends) covered[trail].last = never;
  }
  return covered;
}

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
