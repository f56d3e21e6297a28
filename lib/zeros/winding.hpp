#pragma once
// How far the phase of the guiding field turns along an arc of a circle.

#include <optional>

#include "field/evaluate.hpp"

namespace quadrille::zeros {

struct ArcTurn {
  double turn = 0;                ///< radians, counter-clockwise positive
  double least_value = 0;         ///< least |v| sampled: the turn means little when it is small
  double angle0 = 0, angle1 = 0;  ///< the part of the arc inside the mesh
};

/// Follows the phase counter-clockwise from angle0 to angle1 on the circle. Stretches at both ends of the arc that lie
/// outside the mesh are left out; nothing is returned when the arc leaves the mesh in between or lies outside.
std::optional<ArcTurn> phase_turn(const field::FieldEvaluator& evaluator, Vec2 centre, double radius, double angle0,
                                  double angle1);

/// The index enclosed by the whole circle; nothing when it leaves the mesh.
std::optional<int> circle_index(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                double& least_value);

}  // namespace quadrille::zeros
