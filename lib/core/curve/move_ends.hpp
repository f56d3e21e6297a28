#pragma once
// Moves the ends of a control polygon, in the plane or in space.

#include <cstddef>
#include <vector>

namespace quadrille::curve {

/// The first and last pole become `start` and `end`, bit for bit. Each pole between them moves by the displacements of
/// the two ends, interpolated linearly in the length of the polygon up to it.
template <class Point>
void move_ends(std::vector<Point>& poles, Point start, Point end) {
  std::vector<double> lengths = {0};  // of the polygon up to each pole
  for (std::size_t i = 1; i < poles.size(); ++i) lengths.push_back(lengths.back() + distance(poles[i - 1], poles[i]));
  const Point at_start = start - poles.front(), at_end = end - poles.back();
  for (std::size_t i = 0; i < poles.size(); ++i) {
    const double fraction = lengths.back() > 0 ? lengths[i] / lengths.back() : 0;
    poles[i] += (1 - fraction) * at_start + fraction * at_end;
  }
  poles.front() = start, poles.back() = end;
}

}  // namespace quadrille::curve
