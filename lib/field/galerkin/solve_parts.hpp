#pragma once
// Further harmonic functions on the mesh of a field: one factorisation, a right-hand side for each.

#include <memory>
#include <vector>

#include "field/corner_tilt.hpp"
#include "field/harmonic_part.hpp"
#include "galerkin/continuous.hpp"

namespace quadrille::galerkin {

/// The functions with these boundary data, by continuous elements. `context`, `system` and `points` are of one mesh;
/// the system is factored for the orders of the field to which the functions are added.
std::vector<field::HarmonicPart> solve_parts(const MeshContext& context, ContinuousSystem& system,
                                             const std::shared_ptr<BoundaryPoints>& points,
                                             const std::vector<field::LiftedData>& data);

}  // namespace quadrille::galerkin
