#include "curve/move_ends.hpp"

#include <cstddef>
#include <vector>

#include "curve/nurbs.hpp"

namespace quadrille::curve {

Nurbs with_ends(Nurbs curve, Vec2 start, Vec2 end) {
  if (curve.degree == 1 && curve.poles.size() == 2) return segment(start, end);
  std::vector<double> lengths = {0};  // of the control polygon up to each pole
  for (std::size_t i = 1; i < curve.poles.size(); ++i)
    lengths.push_back(lengths.back() + distance(curve.poles[i - 1], curve.poles[i]));
  const Vec2 at_start = start - curve.poles.front(), at_end = end - curve.poles.back();
  for (std::size_t i = 0; i < curve.poles.size(); ++i) {
    const double fraction = lengths.back() > 0 ? lengths[i] / lengths.back() : 0;
    curve.poles[i] += (1 - fraction) * at_start + fraction * at_end;
  }
  curve.poles.front() = start, curve.poles.back() = end;
  return curve;
}

}  // namespace quadrille::curve
