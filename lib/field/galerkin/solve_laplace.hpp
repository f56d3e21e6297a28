#pragma once
// Both Laplace problems of the guiding field (paper, eq. 4), by continuous or hybridised discontinuous Galerkin on
// triangles, interior modes condensed, one sparse Cholesky factorisation for u and v.

#include <memory>
#include <vector>

#include "base/report.hpp"
#include "galerkin/dirichlet.hpp"
#include "galerkin/discretization.hpp"
#include "model/field.hpp"

namespace quadrille::galerkin {

/// Treatment of the jumps of the boundary data at corners.
enum class CornerData {
  lift,  ///< represented by exact harmonic liftings (field/boundary_values.hpp)
  dg     ///< kept in the data, as in the paper; discontinuous elements only
};
constexpr auto enum_names(CornerData) { return std::to_array({"lift", "dg"}); }

struct LaplaceOptions {
  FieldMethod method = FieldMethod::cg;  ///< orders 1 to max_field_order(method)
  CornerData corners = CornerData::lift;
  int num_threads = 1;       ///< the result does not depend on it
  Alignment alignment = {};  ///< -Δv + mu v = f in place of Laplace's equation; continuous elements only
};

/// The greatest polynomial order of a field.
constexpr int max_field_order(FieldMethod method) { return method == FieldMethod::dg ? 12 : 20; }

/// Solves on `mesh` with order elem_order[e] on element e, data and liftings from mesh.face. Linear in the number of
/// elements but for the sparse factorisation. Warns (W-SOLVE-001) of a line field (field/boundary_values.hpp), whose
/// zeros are curves. Throws ComputeError if the factorisation breaks down, or if data with jumps are prescribed for
/// continuous elements; UsageError for an alignment of discontinuous ones.
Field solve_laplace(const TriMesh& mesh, const std::vector<int>& elem_order, const LaplaceOptions& options,
                    Report& report);
/// The same with default options.
Field solve_laplace(const TriMesh& mesh, const std::vector<int>& elem_order, Report& report);

/// solve_laplace() for successive order maps on one mesh: elements whose order has not changed keep their matrices.
class LaplaceSolver {
 public:
  /// Boundary data of the guiding field. `mesh` must outlive the solver.
  explicit LaplaceSolver(const TriMesh& mesh, const LaplaceOptions& options = {});
  /// Arbitrary boundary data; they must be continuous if the method is cg.
  LaplaceSolver(const TriMesh& mesh, BoundaryData data, FieldMethod method = FieldMethod::cg);
  LaplaceSolver(const LaplaceSolver&) = delete;  // the discretisation refers to it
  LaplaceSolver& operator=(const LaplaceSolver&) = delete;
  Field solve(const std::vector<int>& elem_order, Report& report);
  /// Size of the condensed system for this order map.
  int num_unknowns(const std::vector<int>& elem_order) const { return discretization_->num_unknowns(elem_order); }

 private:
  std::unique_ptr<MeshContext> context_;
  FieldMethod method_;
  std::vector<Lifting> liftings_;
  Alignment alignment_;
  std::unique_ptr<const field::AlignmentTerm> term_;
  std::unique_ptr<Discretization> discretization_;
};

/// The options with which `field` was solved.
LaplaceOptions options_of(const Field& field);

}  // namespace quadrille::galerkin
