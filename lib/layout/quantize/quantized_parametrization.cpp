#include "quantize/quantized_parametrization.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace quadrille::quantize {
namespace {

constexpr int num_rounds = 50;
constexpr double least_distance = 0.25;  // of neighbours on an arc, relative to their even distance

// Enforces the least distance between crossings of one arc: raises fractions in order, then lowers them in reverse
// order.
void keep_apart(std::map<int, double>& fractions, int length) {
  const double gap = least_distance / length;
  int last = 0;
  double low = 0;
  for (auto& [number, fraction] : fractions) {
    fraction = std::max(fraction, low + gap * (number - last));
    low = fraction, last = number;
  }
  last = length;
  double high = 1;
  for (auto crossing = fractions.rbegin(); crossing != fractions.rend(); ++crossing) {
    crossing->second = std::min(crossing->second, high - gap * (last - crossing->first));
    high = crossing->second, last = crossing->first;
  }
}

}  // namespace

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

IsoLines iso_lines(const ArcGraph& t_mesh, const IntegerSides& sides) {
  struct FaceLine {
    int face = 0, direction = 0, offset = 0;
  };
  IsoLines result;
  result.crossings.resize(t_mesh.arcs.size());
  result.lines.resize(sides.faces().size());
  std::vector<FaceLine> unfinished;
  // The line of a face through a position of a side; not at the side's ends.
  const auto start = [&](int face, int side, int position) {
    const int direction = side % 2;
    const int offset = side < 2 ? position : sides.total(face, direction) - position;
    if (result.lines[face][direction].insert(offset).second) unfinished.push_back({face, direction, offset});
  };
  // A line reaches a side: at a node it is the line of a T-junction there, elsewhere it crosses the arc.
  const auto continue_beyond = [&](int face, int side, int position) {
    const auto [h, number] = sides.half_edge_at(face, side, position);
    const int length = sides.arc(h.arc);
    if (number == length) return;
    const bool is_new = result.crossings[h.arc].insert(!h.is_backwards ? number : length - number).second;
    const SidePosition& behind = sides.position_of(h.reversed());
    if (is_new && behind.face >= 0) start(behind.face, behind.side, behind.offset + length - number);
  };
  for (int f = 0; f < static_cast<int>(sides.faces().size()); ++f)
    for (int side = 0; side < 4; ++side) {
      const std::vector<HalfEdge>& half_edges = sides.faces()[f][side];
      for (size_t k = 1; k < half_edges.size(); ++k)  // T-junctions
        start(f, side, sides.position_of(half_edges[k]).offset);
    }
  while (!unfinished.empty()) {
    const FaceLine line = unfinished.back();
    unfinished.pop_back();
    continue_beyond(line.face, line.direction, line.offset);
    continue_beyond(line.face, line.direction + 2, sides.total(line.face, line.direction) - line.offset);
  }
  return result;
}

std::vector<TFace> faces_across_periodic_sides(std::vector<TFace> faces, const std::vector<HalfEdge>& same) {
  if (same.empty()) return faces;
  for (TFace& face : faces)
    for (std::vector<HalfEdge>& side : face)
      for (HalfEdge& h : side) h = h.is_backwards ? same[h.arc].reversed() : same[h.arc];
  return faces;
}

QuantizedParametrization::QuantizedParametrization(const ArcGraph& t_mesh, const std::vector<TFace>& faces,
                                                   const std::vector<int>& lengths, std::vector<double> arc_lengths,
                                                   const std::vector<HalfEdge>& same)
    : glued_(faces_across_periodic_sides(faces, same)),
      own_sides_(faces, lengths),
      glued_sides_(glued_, lengths),
      lines_(iso_lines(t_mesh, glued_sides_)),
      arc_lengths_(std::move(arc_lengths)),
      fractions_(arc_lengths_.size()) {
  for (size_t a = 0; a < fractions_.size(); ++a)
    for (const int number : lines_.crossings[a]) fractions_[a][number] = static_cast<double>(number) / lengths[a];
  for (int round = 0; round < num_rounds; ++round) straighten();
  copy_to_images(same);
  is_finished_ = true;
}

// Both run in opposite directions.
void QuantizedParametrization::copy_to_images(const std::vector<HalfEdge>& same) {
  for (int a = 0; a < static_cast<int>(same.size()); ++a) {
    if (same[a].arc == a) continue;
    const int length = glued_sides_.arc(a);
    for (const auto& [number, fraction] : fractions_[same[a].arc]) {
      fractions_[a][length - number] = 1 - fraction;
      lines_.crossings[a].insert(length - number);
    }
  }
}

// All arcs are updated at once, so that none is preferred.
void QuantizedParametrization::straighten() {
  CrossingFractions next = fractions_;
  for (int a = 0; a < static_cast<int>(next.size()); ++a) {
    for (auto& [number, fraction] : next[a]) fraction = (fraction + straightened(a, number)) / 2;
    keep_apart(next[a], sides().arc(a));
  }
  fractions_ = std::move(next);
}

// The mean of the fractions opposite to a crossing in the faces on both sides of its arc.
double QuantizedParametrization::straightened(int arc, int number) const {
  double sum = 0;
  int count = 0;
  for (const HalfEdge h : {HalfEdge{arc}, HalfEdge{arc, true}}) {
    const SidePosition& at = sides().position_of(h);
    if (at.face < 0) continue;
    const int position = at.offset + (!h.is_backwards ? number : sides().arc(arc) - number);
    const int across = (at.side + 2) % 4, total = sides().total(at.face, across);
    sum += arc_fraction(h, 1 - side_fraction(at.face, across, total - position));
    ++count;
  }
  return sum / count;
}

// Fraction of the half-edge's arc at a fraction of its side; outside 0 ... 1 beyond the half-edge.
double QuantizedParametrization::arc_fraction(HalfEdge h, double fraction_of_side) const {
  const SidePosition& at = sides().position_of(h);
  double before = 0, total = 0;
  for (const HalfEdge other : sides().faces()[at.face][at.side]) {
    if (other == h) before = total;
    total += arc_lengths_[other.arc];
  }
  const double along = (fraction_of_side * total - before) / arc_lengths_[h.arc];
  return !h.is_backwards ? along : 1 - along;
}

double QuantizedParametrization::side_fraction(int face, int side, int position) const {
  const auto [last, number] = sides().half_edge_at(face, side, position);
  const int arc = last.arc, length = sides().arc(arc);
  double before = 0, total = 0;
  for (const HalfEdge h : sides().faces()[face][side]) {
    if (h == last) before = total;
    total += arc_lengths_[h.arc];
  }
  if (number == length) return (before + arc_lengths_[arc]) / total;
  const double along = !last.is_backwards ? fractions_[arc].at(number) : 1 - fractions_[arc].at(length - number);
  return (before + along * arc_lengths_[arc]) / total;
}

}  // namespace quadrille::quantize
