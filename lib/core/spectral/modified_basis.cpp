#include "spectral/modified_basis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

// A function's value and its derivatives with respect to xi1 and xi2.
struct Jet {
  double f = 0, d1 = 0, d2 = 0;
};

Jet operator+(Jet a, Jet b) { return {a.f + b.f, a.d1 + b.d1, a.d2 + b.d2}; }
Jet operator-(Jet a, Jet b) { return {a.f - b.f, a.d1 - b.d1, a.d2 - b.d2}; }
Jet operator*(double s, Jet a) { return {s * a.f, s * a.d1, s * a.d2}; }
Jet operator*(Jet a, Jet b) { return {a.f * b.f, a.d1 * b.f + a.f * b.d1, a.d2 * b.f + a.f * b.d2}; }

// q_0..q_n at (x, t), which are jets or numbers.
template <class Number>
std::vector<Number> scaled_jacobi(int n, Number x, Number t, Number one) {
  std::vector<Number> q(n + 1, one);
  const Number t2 = t * t;
  for (int k = 0; k < n; ++k) {
    const JacobiStep step = jacobi_step(k, 1, 1);
    q[k + 1] = step.a * (x * q[k]);
    if (k > 0) q[k + 1] = q[k + 1] - step.c * (t2 * q[k - 1]);
  }
  return q;
}

// The modes of degree 2..P: product * q(x, t).
template <class Number>
void append_edge(int order, Number product, Number x, Number t, Number one, std::vector<Number>& modes) {
  if (order < 2) return;
  const std::vector<Number> q = scaled_jacobi(order - 2, x, t, one);
  for (int d = 2; d <= order; ++d) modes.push_back(edge_mode_scale(d) * (product * q[d - 2]));
}

// P_0..P_n^(2i+3,1)(2 l - 1).
std::vector<Jet> upward_jacobi(int n, int i, Jet l) {
  std::vector<Jet> values(n + 1, Jet{1, 0, 0});
  const Jet x = 2.0 * l - Jet{1, 0, 0};
  for (int k = 0; k < n; ++k) {
    const JacobiStep step = jacobi_step(k, 2 * i + 3, 1);
    values[k + 1] = (step.a * x + Jet{step.b, 0, 0}) * values[k];
    if (k > 0) values[k + 1] = values[k + 1] - step.c * values[k - 1];
  }
  return values;
}

void append_interior(int order, const std::array<Jet, 3>& l, std::vector<Jet>& modes) {
  if (order < 3) return;
  const int top = order - 3;
  const Jet one{1, 0, 0}, bubble = l[0] * l[1] * l[2];
  const std::vector<Jet> across = scaled_jacobi(top, l[1] - l[0], l[0] + l[1], one);
  std::vector<std::vector<Jet>> upward;
  for (int i = 0; i <= top; ++i) upward.push_back(upward_jacobi(top - i, i, l[2]));
  for (int degree = 0; degree <= top; ++degree) {
    for (int i = 0; i <= degree; ++i) modes.push_back(bubble * across[i] * upward[i][degree - i]);
  }
}

std::vector<Jet> modified_jets(int order, Vec2 xi) {
  const std::array<Jet, 3> l{Jet{-(xi.x + xi.y) / 2, -0.5, -0.5}, Jet{(1 + xi.x) / 2, 0.5, 0},
                             Jet{(1 + xi.y) / 2, 0, 0.5}};
  std::vector<Jet> modes(l.begin(), l.end());
  modes.reserve(num_tri_modes(order));
  const Jet one{1, 0, 0}, upward = 2.0 * l[2] - one;
  append_edge(order, l[0] * l[1], l[1] - l[0], l[0] + l[1], one, modes);
  append_edge(order, l[1] * l[2], upward, one, one, modes);
  append_edge(order, l[2] * l[0], -1.0 * upward, one, one, modes);
  append_interior(order, l, modes);
  return modes;
}

std::vector<int> make_subset(int order, int higher_order) {
  std::vector<int> modes{0, 1, 2};
  for (int edge = 0; edge < 3; ++edge) {
    for (int d = 2; d <= order; ++d) modes.push_back(edge_mode(higher_order, edge, d));
  }
  for (int i = 0; i < num_interior_modes(order); ++i) modes.push_back(num_boundary_modes(higher_order) + i);
  return modes;
}

}  // namespace

void modified_gradients(int order, Vec2 xi, double* values, double* d_xi1, double* d_xi2) {
  for (const Jet& mode : modified_jets(order, xi)) {
    *values++ = mode.f;
    *d_xi1++ = mode.d1;
    *d_xi2++ = mode.d2;
  }
}

const std::vector<int>& modified_subset(int order, int higher_order) {
  static PerOrder<std::vector<int>> tables([](int key) { return make_subset(key / 100, key % 100); });
  return tables[100 * order + higher_order];
}

void edge_mode_values(int order, double s, double* values) {
  std::vector<double> modes;
  append_edge(order, (1 - s) * (1 + s) / 4, s, 1.0, 1.0, modes);
  std::copy(modes.begin(), modes.end(), values);
}

}  // namespace quadrille::spectral
