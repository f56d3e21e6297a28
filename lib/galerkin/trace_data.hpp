#pragma once
// Boundary data of the hybridised method: on each edge by itself, so that they may jump where two edges meet.

#include <Eigen/Dense>

#include "galerkin/dirichlet.hpp"
#include "galerkin/dof_map.hpp"

namespace quadrille::galerkin {

/// Values of the trace dofs [num_unknowns, num_dofs), columns u, v: the projection in the mean square along each edge.
/// The point at fraction s of an edge lies at fraction s of the curve's arc length. Data are never asked for at the
/// ends of an edge.
Eigen::MatrixXd trace_data(const TriMesh& mesh, const mesh::TriTopology& topology, const DofMap& map,
                           const BoundaryData& data);

}  // namespace quadrille::galerkin
