#include "quantize/integer_grid.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace quadrille::quantize {

IntegerSides::IntegerSides(const std::vector<TFace>& faces, const std::vector<int>& lengths)
    : faces_(faces), lengths_(lengths), places_(2 * lengths.size()) {
  for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
    totals_.push_back({});
    for (int side = 0; side < 4; ++side)
      for (const HalfEdge h : faces[f][side]) {
        places_[h.index()] = {f, side, totals_[f][side]};
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

GridLines::GridLines(const SeparatrixGraph& t_mesh, const IntegerSides& sides)
    : marks(t_mesh.arcs.size()), lines(sides.faces().size()), t_mesh_(t_mesh), sides_(sides) {
  for (int f = 0; f < static_cast<int>(sides.faces().size()); ++f)
    for (int side = 0; side < 4; ++side) {
      const std::vector<HalfEdge>& half_edges = sides.faces()[f][side];
      for (size_t k = 1; k < half_edges.size(); ++k) ask(f, side, sides.place(half_edges[k]).offset);
    }
  while (!asked_.empty()) {
    const Asked line = asked_.back();
    asked_.pop_back();
    reach(line.face, line.direction, line.offset);
    reach(line.face, line.direction + 2, sides_.total(line.face, line.direction) - line.offset);
  }
}

void GridLines::ask(int face, int side, int position) {
  const int direction = side % 2;
  const int offset = side < 2 ? position : sides_.total(face, direction) - position;
  if (lines[face][direction].insert(offset).second) asked_.push_back({face, direction, offset});
}

// The line comes to a side: at a node it is the line of a T-junction there, else it goes on behind the arc.
void GridLines::reach(int face, int side, int position) {
  const auto [h, number] = sides_.half_edge_at(face, side, position);
  const int arc = h.arc, length = sides_.arc(arc);
  if (number == length) return;
  if (!marks[arc].insert(!h.is_backwards ? number : length - number).second || t_mesh_.arcs[arc].is_boundary) return;
  const SidePosition& behind = sides_.place(h.reversed());
  ask(behind.face, behind.side, behind.offset + length - number);
}

namespace {

constexpr int num_rounds = 50;
constexpr double least_distance = 0.25;  // of neighbours on an arc, as a share of their even distance

// Share of the half-edge's arc where a fraction of the side lies; beyond 0..1 outside the half-edge.
double share_at(const IntegerSides& sides, const std::vector<double>& arc_lengths, HalfEdge h, double fraction) {
  const SidePosition& place = sides.place(h);
  double before = 0, total = 0;
  for (const HalfEdge other : sides.faces()[place.face][place.side]) {
    if (other == h) before = total;
    total += arc_lengths[other.arc];
  }
  const double along = (fraction * total - before) / arc_lengths[h.arc];
  return !h.is_backwards ? along : 1 - along;
}

// In sequence, each in the room that the others leave it.
void keep_apart(std::map<int, double>& shares, int length) {
  const double gap = least_distance / length;
  int last = 0;
  double low = 0;
  for (auto& [number, share] : shares) {
    share = std::max(share, low + gap * (number - last));
    low = share, last = number;
  }
  last = length;
  double high = 1;
  for (auto mark = shares.rbegin(); mark != shares.rend(); ++mark) {
    mark->second = std::min(mark->second, high - gap * (last - mark->first));
    high = mark->second, last = mark->first;
  }
}

}  // namespace

std::vector<std::map<int, double>> mark_shares(const IntegerSides& sides, const GridLines& grid,
                                               const std::vector<double>& arc_lengths) {
  const int num_arcs = static_cast<int>(arc_lengths.size());
  std::vector<std::map<int, double>> shares(num_arcs);
  for (int a = 0; a < num_arcs; ++a)
    for (const int number : grid.marks[a]) shares[a][number] = static_cast<double>(number) / sides.arc(a);
  for (int round = 0; round < num_rounds; ++round) {
    std::vector<std::map<int, double>> next = shares;  // of all at once: no arc is before another
    for (int a = 0; a < num_arcs; ++a) {
      for (auto& [number, share] : next[a]) {
        double sum = 0;
        int count = 0;
        for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}}) {
          const SidePosition& at = sides.place(h);
          if (at.face < 0) continue;
          const int position = at.offset + (!h.is_backwards ? number : sides.arc(a) - number);
          const int across = (at.side + 2) % 4, total = sides.total(at.face, across);
          const double there = side_fraction(sides, shares, arc_lengths, at.face, across, total - position);
          sum += share_at(sides, arc_lengths, h, 1 - there);
          ++count;
        }
        share = (share + sum / count) / 2;
      }
      keep_apart(next[a], sides.arc(a));
    }
    shares = std::move(next);
  }
  return shares;
}

double side_fraction(const IntegerSides& sides, const std::vector<std::map<int, double>>& shares,
                     const std::vector<double>& arc_lengths, int face, int side, int position) {
  const auto [last, number] = sides.half_edge_at(face, side, position);
  const int arc = last.arc, length = sides.arc(arc);
  double before = 0, total = 0;
  for (const HalfEdge h : sides.faces()[face][side]) {
    if (h == last) before = total;
    total += arc_lengths[h.arc];
  }
  if (number == length) return (before + arc_lengths[arc]) / total;
  const double along = !last.is_backwards ? shares[arc].at(number) : 1 - shares[arc].at(length - number);
  return (before + along * arc_lengths[arc]) / total;
}

}  // namespace quadrille::quantize
