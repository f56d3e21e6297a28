#pragma once
// Further harmonic functions on the mesh of a field: one factorisation, a right-hand side for each.

#include <vector>

#include "field/corner_tilt.hpp"
#include "field/harmonic_part.hpp"

namespace quadrille::galerkin {

/// The functions with these boundary data, by continuous elements with the orders of `field`. Throws ComputeError if
/// the factorisation breaks down.
std::vector<field::HarmonicPart> solve_parts(const Field& field, const std::vector<field::LiftedData>& data,
                                             int num_threads);

}  // namespace quadrille::galerkin
