#pragma once
// Boundary data of the hybridised method: projected on each edge separately, so that they may jump where two edges
// meet.

#include <Eigen/Dense>

#include "galerkin/dirichlet.hpp"
#include "galerkin/dof_map.hpp"

namespace quadrille::galerkin {

/// Values of the trace dofs [num_unknowns, num_dofs), columns u, v: the L2 projection along each edge. The point at
/// fraction s of an edge lies at fraction s of the curve's arc length. The data are never evaluated at the ends of an
/// edge.
Eigen::MatrixXd trace_data(const TriMesh& mesh, const mesh::TriTopology& topology, const DofMap& map,
                           const BoundaryData& data);

}  // namespace quadrille::galerkin
