#include "trace/element_exit.hpp"

#include <algorithm>

#include "base/bracketed_root.hpp"

namespace quadrille::trace {
namespace {

constexpr double edge_tol = 1e-12;  // barycentric
constexpr double overshoot = 0.05;  // barycentric: how far a step may extrapolate beyond the element

// Barycentric coordinate that vanishes on a local edge, and its linear part.
double above_edge(int edge, Vec2 xi) {
  return edge == 0 ? (1 + xi.y) / 2 : edge == 1 ? -(xi.x + xi.y) / 2 : (1 + xi.x) / 2;
}
double above_edge_rate(int edge, Vec2 rate) {
  return edge == 0 ? rate.y / 2 : edge == 1 ? -(rate.x + rate.y) / 2 : rate.x / 2;
}

}  // namespace

ElementExit first_exit(const StreamStep& step) {
  ElementExit exit;
  const Vec2 last = step.xi(1);
  for (int edge = 0; edge < 3; ++edge) {
    if (above_edge(edge, last) >= -edge_tol) continue;
    const auto above = [&](double fraction) { return above_edge(edge, step.xi(fraction)); };
    const double fraction = falling_root_to_round_off(above);
    if (fraction < exit.fraction) exit = {edge, fraction};
  }
  return exit;
}

double fraction_along_edge(int edge, Vec2 xi) {
  const double f = edge == 0 ? (1 + xi.x) / 2 : edge == 1 ? (1 + xi.y) / 2 : (1 - xi.y) / 2;
  return std::clamp(f, 0.0, 1.0);
}

double length_to_exit(const StreamState& state, double limit) {
  double length = limit;
  for (int edge = 0; edge < 3; ++edge) {
    const double rate = above_edge_rate(edge, state.rate);
    if (rate < 0) length = std::min(length, (std::max(0.0, above_edge(edge, state.xi)) + overshoot) / -rate);
  }
  return length;
}

}  // namespace quadrille::trace
