#pragma once
// Boundary coefficients of a pair of functions given on the exact curves.

#include <Eigen/Dense>
#include <functional>

#include "galerkin/dof_map.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille {

/// The pair's value at parameter t of a boundary curve.
using BoundaryData = std::function<Vec2(int curve, double t)>;

/// Values of the dofs [num_unknowns, num_dofs), columns u, v: exact at vertices; on an edge the projection in the norm
/// of the derivative along it, which is diagonal in the edge modes. The point at fraction s of an edge lies at fraction
/// s of the curve's arc length, as the element's own geometry nodes do.
Eigen::MatrixX2d dirichlet_values(const TriMesh& mesh, const TriTopology& topology, const DofMap& map,
                                  const BoundaryData& data);

}  // namespace quadrille
