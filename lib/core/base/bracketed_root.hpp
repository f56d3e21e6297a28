#pragma once
// Roots of a continuous function, without derivatives, between two points at which its signs differ.
//
// Three methods, each with its own stopping rule: bisection if the function may jump, false position of the Illinois
// type (Dowell and Jarratt 1971) if evaluations are expensive, false position with a bisection every third step if they
// are cheap and the bracket must shrink to round-off.

#include <cmath>

namespace quadrille {

/// Halves [a, b] until no floating-point number lies between, and returns the point at which f changes its sign. `f(a)`
/// and `f(b)` must have opposite signs.
template <class Function>
double bisect(const Function& f, double a, double b) {
  const bool is_rising = f(b) > f(a);
  for (int i = 0; i < 200; ++i) {
    const double middle = (a + b) / 2;
    if (middle <= a || middle >= b) break;
    ((f(middle) < 0) == is_rising ? a : b) = middle;
  }
  return (a + b) / 2;
}

/// The root of a falling function in [a, b], f(a) > 0 > f(b), by the Illinois method; an end of the interval if f does
/// not change its sign. Stops as soon as |f| <= value_tol b or b - a <= width_tol b, with the current upper end b of
/// the bracket.
template <class Function>
double falling_root(const Function& f, double a, double b, double value_tol, double width_tol) {
  double fa = f(a), fb = f(b);
  if (fb >= 0) return b;
  if (fa <= 0) return a;
  double root = b;
  for (int i = 0, last_side = 0; i < 50; ++i) {
    root = (a * fb - b * fa) / (fb - fa);
    const double value = f(root);
    if (std::abs(value) <= value_tol * b || b - a <= width_tol * b) break;
    const int side = value > 0 ? 1 : -1;
    (side > 0 ? a : b) = root;
    (side > 0 ? fa : fb) = value;
    if (side == last_side) (side > 0 ? fb : fa) /= 2;
    last_side = side;
  }
  return root;
}

/// As falling_root, on [0, 1] and to round-off, for a function with f(1) < 0; returns 0 if f(0) <= 0.
template <class Function>
double falling_root_to_round_off(const Function& f) {
  double a = 0, b = 1, fa = f(0.0), fb = f(1.0);
  if (fa <= 0) return 0;
  for (int i = 0; i < 100; ++i) {
    double middle = i % 3 == 2 ? (a + b) / 2 : a + (b - a) * fa / (fa - fb);
    if (middle <= a || middle >= b) middle = (a + b) / 2;
    if (middle <= a || middle >= b) break;
    const double value = f(middle);
    (value > 0 ? a : b) = middle;
    (value > 0 ? fa : fb) = value;
    if (b - a < 1e-15 || std::abs(value) < 1e-16) return middle;
  }
  return b;
}

}  // namespace quadrille
