#pragma once
// The change of the phase of the guiding field along an arc of a circle.

#include <optional>

#include "field/evaluate.hpp"

namespace quadrille::zeros {

struct ArcTurn {
  double turn = 0;                ///< radians, counter-clockwise positive
  double least_value = 0;         ///< least sampled |v|; if it is small the turn is unreliable
  double angle0 = 0, angle1 = 0;  ///< the part of the arc inside the mesh
};

/// Follows the phase counter-clockwise from angle0 to angle1 (radians) on the circle. Parts at both ends of the arc
/// that lie outside the mesh are ignored. Returns std::nullopt if the arc is interrupted by a part outside the mesh or
/// lies outside.
std::optional<ArcTurn> phase_turn(const field::FieldEvaluator& evaluator, Vec2 centre, double radius, double angle0,
                                  double angle1);

/// The index enclosed by the whole circle; std::nullopt if the circle is not inside the mesh.
std::optional<int> circle_index(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                double& least_value);

}  // namespace quadrille::zeros
