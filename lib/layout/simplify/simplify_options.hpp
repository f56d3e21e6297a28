#pragma once
// Bounds on the changes that simplification makes to a layout.

namespace quadrille::simplify {

struct SimplifyOptions {
  double max_deviation = 0.44;  ///< radians: of a new line from the cross of the field
  /// Bounds of the blocks that a step changes; a bound that one of them exceeded before does not apply: corner angles
  /// (radians), and the scaled Jacobian of a block as one quad of order 8, whose Jacobian must be proved positive.
  double least_angle = 0.26, greatest_angle = 2.88;
  double least_scaled_jacobian = 0.3;
  /// The least scaled Jacobian of the changed blocks may decrease at most by the fraction of all blocks that the step
  /// removes.
  bool limits_loss_by_saving = true;
};

}  // namespace quadrille::simplify
