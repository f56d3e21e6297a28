#pragma once
// A harmonic function that may be added to a field: its coefficients on the mesh and with the orders of that field.

#include <vector>

#include "model/field.hpp"

namespace quadrille::field {

/// Coefficients of the elements on which the function is not negligible.
struct HarmonicPart {
  std::vector<int> elems;
  std::vector<double> u, v;  ///< element after element
  std::vector<Lifting> liftings;
};

/// Adds `factor` times `part` to a harmonic field with the same orders.
void add(const HarmonicPart& part, double factor, Field& field);

}  // namespace quadrille::field
