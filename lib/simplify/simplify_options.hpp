#pragma once
// What simplification may do to a layout.

namespace quadrille::simplify {

struct SimplifyOptions {
  double max_deviation = 0.44;  ///< radians: of a new line from the cross of the field
  /// Bounds of the blocks that a step changes, each unless one of them was beyond it before: corner angles (radians),
  /// and the scaled Jacobian of a block as one quad of order 8, whose Jacobian must be proved positive.
  double least_angle = 0.26, greatest_angle = 2.88;
  double least_scaled_jacobian = 0.3;
  /// No step may take a greater fraction of the least scaled Jacobian of the blocks it changes than it saves of all
  /// blocks.
  bool limits_loss_by_saving = true;
};

}  // namespace quadrille::simplify
