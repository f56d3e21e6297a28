#pragma once
// The gradient of the energy W with respect to the positions of irregular nodes (galerkin/phase_energy.hpp).

#include "mesh/locate.hpp"
#include "model/phase_nodes.hpp"
#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::galerkin {

/// dW / da_k; `remainder_slope`: the gradient of s at a_k.
Vec2 phase_energy_gradient(const PhaseTerms& terms, int k, Vec2 remainder_slope);

/// Gradient of s with respect to x; `coefs`: coefficients of s in the orthogonal basis.
Vec2 remainder_gradient(const spectral::TriMap& map, Vec2 xi, int order, const double* coefs);

/// The location of a node in the mesh. Throws ComputeError if the node is not inside the mesh.
mesh::Location locate_node(const mesh::Locator& locator, const TriMesh& mesh, Vec2 node);

}  // namespace quadrille::galerkin
