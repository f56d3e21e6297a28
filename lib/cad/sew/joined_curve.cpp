#include "sew/joined_curve.hpp"

#include "base/error.hpp"

namespace quadrille::sew {

Nurbs joined_curve(const Nurbs& a, const Nurbs& b) {
  if (a.degree != b.degree) throw Defect("joined_curve: curves of different degrees");
  Nurbs joined = a;
  joined.knots.pop_back();
  for (auto knot = b.knots.begin() + b.degree + 1; knot != b.knots.end(); ++knot)
    joined.knots.push_back(a.end() + (*knot - b.begin()));
  // All weights of a rational curve may be multiplied by one number.
  const double factor = a.weights.back() / b.weights.front();
  joined.poles.insert(joined.poles.end(), b.poles.begin() + 1, b.poles.end());
  for (auto weight = b.weights.begin() + 1; weight != b.weights.end(); ++weight)
    joined.weights.push_back(factor * *weight);
  return joined;
}

}  // namespace quadrille::sew
