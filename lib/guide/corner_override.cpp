#include <cmath>

#include "guide/resolve.hpp"

namespace quadrille {

bool is_admissible_valence(double angle_degrees, int valence) {
  constexpr double tol = 1e-6;
  if (valence == 0) return true;
  return valence > 0 && angle_degrees / valence >= 15 - tol && angle_degrees / valence <= 165 + tol;
}

}  // namespace quadrille
