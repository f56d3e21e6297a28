#pragma once
// One step of a streamline in the reference triangle of one element: the embedded Runge-Kutta pair of Dormand and
// Prince, orders 5 and 4, with its continuous extension of order 4 (Hairer, Norsett, Wanner, "Solving ODEs I", II.5-6).
//
//   d xi / d s = (d x / d xi)^-1 e(psi'(x(xi))),   s the arc length, psi' the guided cross angle (paper, eq. 2 ff.)

#include <array>

#include "base/vec2.hpp"
#include "field/evaluate.hpp"

namespace quadrille::trace {

/// The `elem` of a step whose coordinates are positions in the plane.
inline constexpr int in_the_plane = -1;

/// An accepted step, or the part of it up to the element's edge.
struct StreamStep {
  int elem = 0;       ///< or in_the_plane
  double s = 0;       ///< arc length at its beginning
  double h = 0;       ///< length of the whole step
  double length = 0;  ///< of the part that is used, <= h
  std::array<Vec2, 5> dense{};

  /// Reference coordinates at fraction theta of h.
  Vec2 xi(double theta) const;
  /// d xi / d theta.
  Vec2 slope(double theta) const;
};

/// State between steps.
struct StreamState {
  int elem = 0;
  Vec2 xi;
  double angle = 0;          ///< direction of the line, radians, continuous
  Vec2 rate;                 ///< d xi / d s
  bool is_straight = false;  ///< the direction stays as it is, whatever the field is
};

/// The state at (elem, xi) with the direction of the cross nearest to `direction` (radians), or with `direction` itself
/// if the line is straight.
StreamState stream_state(const field::FieldEvaluator& evaluator, int elem, Vec2 xi, double direction,
                         bool is_straight = false);

/// Tries a step of length h from `state`. `step.dense` and `end` receive the result; `error` is the estimated error's
/// length in the plane, infinite if the direction turns by more than 0.6 rad within the step, the field vanishes, or
/// det(dx/dxi) is not positive.
void try_step(const field::FieldEvaluator& evaluator, const StreamState& state, double h, StreamStep& step,
              StreamState& end, double& error);

}  // namespace quadrille::trace
