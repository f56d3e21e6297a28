#include "guide/admissible_valence.hpp"

#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "guide/valence.hpp"

namespace quadrille::guide {

bool is_admissible_valence(double angle_degrees, int valence) {
  constexpr double tol = tolerance::tied;
  if (valence == 0) return true;
  const double block = angle_degrees / valence;
  return valence > 0 && valence <= greatest_corner_valence && block <= greatest_block_angle + tol &&
         (valence == 1 || block >= least_block_angle - tol);
}

bool is_admissible_after_absorption(double angle_degrees, int valence) {
  if (valence == 0) return std::abs(angle_degrees - 45) < degrees(near_tie);
  const double block = angle_degrees / valence;
  return valence > 0 && valence <= greatest_corner_valence && block >= least_block_angle &&
         block <= greatest_block_angle && std::abs(valence - angle_degrees / 90) <= 0.75;
}

}  // namespace quadrille::guide
