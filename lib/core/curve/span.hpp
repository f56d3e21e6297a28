#pragma once
// One knot span of a NURBS curve, evaluated in homogeneous coordinates on the stack (The NURBS Book, A2.1, A4.1).
// Private to this folder.

#include <algorithm>
#include <array>
#include <type_traits>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// The largest degree that the CAD kernel and the formats allow.
inline constexpr int max_curve_degree = 25;

/// A pole times its weight, and the weight.
struct Homogeneous {
  double x, y, w;
};

/// The span k with knots[k] <= t < knots[k+1] (from the left: knots[k] < t <= knots[k+1]); never an empty span.
inline int find_span(const Nurbs& curve, double t, bool from_left = false) {
  const int first = curve.degree, last = static_cast<int>(curve.poles.size()) - 1;
  const auto begin = curve.knots.begin() + first, end = curve.knots.begin() + last + 1;
  if (t <= *begin) return static_cast<int>(std::upper_bound(begin, end, *begin) - curve.knots.begin()) - 1;
  if (t >= *end) return static_cast<int>(std::lower_bound(begin, end, *end) - curve.knots.begin()) - 1;
  const auto above = from_left ? std::lower_bound(begin, end, t) : std::upper_bound(begin, end, t);
  return static_cast<int>(above - curve.knots.begin()) - 1;
}

/// Not initialised: clearing the storage for the highest degree would cost as much as the evaluation.
using LocalPoles = std::array<Homogeneous, max_curve_degree + 1>;

/// The degree + 1 poles on which span k depends; `degree` is the curve's, int or a constant.
template <class Degree>
LocalPoles local_poles(const Nurbs& curve, int k, Degree degree) {
  LocalPoles local;
  for (int i = 0; i <= degree; ++i) {
    const int j = k - degree + i;
    const double w = curve.weights[j];
    local[i] = {w * curve.poles[j].x, w * curve.poles[j].y, w};
  }
  return local;
}

/// Calls `work` with the degree, for those of lines, arcs and fitted splines as a constant, so that loops over it are
/// unrolled and poles stay in registers: the same operations in a third of the time.
template <class Work>
auto with_degree(int degree, Work work) {
  switch (degree) {
    case 1:
      return work(std::integral_constant<int, 1>());
    case 2:
      return work(std::integral_constant<int, 2>());
    case 3:
      return work(std::integral_constant<int, 3>());
    default:
      return work(degree);
  }
}

/// De Boor's algorithm on span k for the local poles of a curve of `degree` (which may be a derivative of a curve of
/// the higher degree `curve.degree`); step r uses parameter(r): a constant for a point, distinct ones for a blossom.
/// `degree`: int or a constant, as with_degree() gives it.
template <class Degree, class Parameter>
Homogeneous de_boor(const Nurbs& curve, int k, Degree degree, const LocalPoles& poles, Parameter parameter) {
  LocalPoles d;
  std::copy_n(poles.begin(), degree + 1, d.begin());
  for (int r = 1; r <= degree; ++r) {
    const double t = parameter(r);
    for (int j = degree; j >= r; --j) {
      const double low = curve.knots[k - degree + j], high = curve.knots[k + 1 + j - r];
      const double a = (t - low) / (high - low), b = 1 - a;
      d[j] = {b * d[j - 1].x + a * d[j].x, b * d[j - 1].y + a * d[j].y, b * d[j - 1].w + a * d[j].w};
    }
  }
  return d[degree];
}

/// The first `degree` become the poles of the derivative of the polynomial piece on span k: The NURBS Book, eq. 3.8.
template <class Degree>
void differentiate(const Nurbs& curve, int k, Degree degree, LocalPoles& d) {
  for (int i = 0; i < degree; ++i) {
    const double s = degree / (curve.knots[k + 1 + i] - curve.knots[k + 1 - degree + i]);
    d[i] = {s * (d[i + 1].x - d[i].x), s * (d[i + 1].y - d[i].y), s * (d[i + 1].w - d[i].w)};
  }
}

}  // namespace quadrille::curve
