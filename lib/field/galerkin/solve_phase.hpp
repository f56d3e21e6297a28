#pragma once
// The unit cross field with exactly the prescribed irregular nodes and corner valences (lib/method.md §8): s of §8.3 by
// one continuous Laplace solve, the hole winding by §8.6.

#include <Eigen/Core>
#include <Eigen/Dense>
#include <memory>
#include <vector>

#include "base/report.hpp"
#include "field/corner_tilt.hpp"
#include "field/phase_boundary.hpp"
#include "model/field.hpp"

namespace quadrille::galerkin {

class ContinuousSystem;

/// W and dW / da_k for each node k (galerkin/phase_energy.hpp).
struct PhaseEnergy {
  double value = 0;
  std::vector<Vec2> gradient;
};

/// Solves for many sets of nodes on one mesh and for successive order maps: one factorisation for each order map, which
/// serves the harmonic measures of all holes and other harmonic functions too. Each set of nodes costs new boundary
/// data and one back substitution. `winding_offsets`: from the hole winding of least energy, one integer for each hole
/// (loops 1, 2, ...); empty: all 0. With a non-zero offset, streamlines spiral around the hole.
class PhaseSolver {
 public:
  /// Order elem_order[e] on element e. `mesh` must outlive the solver. The system is factored at first use. With an
  /// `alignment`, solve() and harmonic_parts() are those of -Δv + mu v = f; energies and the winding of holes, which
  /// follows from them, are those without it.
  PhaseSolver(const TriMesh& mesh, std::vector<int> elem_order, int num_threads = 1, Alignment alignment = {});
  ~PhaseSolver();
  PhaseSolver(PhaseSolver&&) noexcept;
  /// Elements whose order does not change keep their matrices.
  void set_orders(std::vector<int> elem_order);

  /// Computes the boundary data of these nodes, which solve() and energy() of the same nodes use again. Throws
  /// ComputeError for infeasible nodes (PhaseBoundary).
  void set_nodes(const PhaseNodes& asked);
  /// The boundary data of the last nodes, null before there are any; valid until others follow.
  const field::PhaseBoundary* boundary() const;

  /// The field of kind "phase". Throws ComputeError for infeasible nodes (PhaseBoundary) and if the factorisation
  /// breaks down, UsageError unless the winding offsets are empty or one per hole.
  Field solve(const PhaseNodes& asked, const std::vector<int>& winding_offsets, Report& report);
  /// The energy W of the field and its gradient. Throws as solve(), and ComputeError if a node lies outside the mesh
  /// (between a curve and its elements).
  PhaseEnergy energy(const PhaseNodes& asked, const std::vector<int>& winding_offsets = {});
  /// Harmonic functions (or those of -Δv + mu v = 0) with these boundary data, to be added to a field on this mesh with
  /// this order map. Smaller coefficients than `negligible` are omitted; what those below 1e-13 add up to is far below
  /// the error of any field. Throws ComputeError if the factorisation breaks down.
  std::vector<field::HarmonicPart> harmonic_parts(const std::vector<field::LiftedData>& data,
                                                  double negligible = 1e-13);
  /// Size of the condensed system for this order map.
  int num_unknowns(const std::vector<int>& elem_order) const;

 private:
  struct Given;
  struct KnownEnergy;
  struct Parts;
  struct State;
  void factor();
  void measure_holes();
  ContinuousSystem& aligned_system();
  State state(const PhaseNodes& asked, const std::vector<int>& winding_offsets);
  void solve_for_winding(const Eigen::MatrixXd& data, State& state);
  Eigen::VectorXd nearest_winding(const State& state) const;
  std::unique_ptr<Parts> parts_;
};

/// Solves for one set of nodes; throws as PhaseSolver::solve().
Field solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked,
                  const std::vector<int>& winding_offsets, Report& report);
Field solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked, Report& report);

}  // namespace quadrille::galerkin
