#pragma once
// Both Laplace problems of the guiding field (paper, eq. 4) by continuous Galerkin: modified hierarchical basis on
// triangles, minimum rule on edges, static condensation, one sparse Cholesky factorisation for u and v.

#include <vector>

#include "base/report.hpp"
#include "model/field.hpp"

namespace quadrille {

/// Solves on `mesh` with order elem_order[e] on element e, data and liftings from mesh.face. Linear in the number of
/// elements but for the sparse factorisation. Throws ComputeError when the factorisation breaks down.
Field solve_laplace(const TriMesh& mesh, const std::vector<int>& elem_order, Report& report);

}  // namespace quadrille
