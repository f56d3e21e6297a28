#pragma once
// What is known of a mesh's elements: the proved lower bounds of det J and the scaled Jacobians (method.md §7).

#include <vector>

#include "base/report.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille {

/// The geometry nodes of one element, as model/quad_mesh.hpp numbers them.
std::vector<Vec2> element_nodes(const QuadMesh& mesh, int elem);

/// Fills in the bounds and scaled Jacobians of all elements.
void measure_elements(QuadMesh& mesh);

/// Whether every element is proved valid: all bounds are positive.
bool is_proved_valid(const QuadMesh& mesh);

/// Throws ComputeError with the place of the worst element when one is not proved valid.
void require_valid_elements(const QuadMesh& mesh);

/// The least bound and scaled Jacobian.
void tell_validity(const QuadMesh& mesh, Report& report);

}  // namespace quadrille
