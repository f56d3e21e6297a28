#pragma once
// The unit cross field with exactly the irregular nodes and corner valences asked for (lib/method.md §8): s of §8.3 by
// one continuous Laplace solve, the twists of the holes by §8.6.

#include <memory>
#include <vector>

#include "base/report.hpp"
#include "model/field.hpp"

namespace quadrille::galerkin {

struct PhaseOptions {
  /// Added to the twists of least energy, one for each hole (loops 1, 2, ...); empty: none. Lines wind round a hole for
  /// ever where it is not 0.
  std::vector<int> hole_winding_offsets;
};

/// W and its gradient for each node (galerkin/phase_energy.hpp).
struct PhaseEnergy {
  double value = 0;
  std::vector<Vec2> gradient;
};

/// Solves for many sets of nodes on one mesh and for a sequence of order maps: one factorisation for each order map,
/// the harmonic measures of all holes included. A set of nodes costs new boundary data and a back substitution.
class PhaseSolver {
 public:
  /// Order elem_order[e] on element e. `mesh` must outlive the solver. The factorisation is made at its first use.
  PhaseSolver(const TriMesh& mesh, std::vector<int> elem_order, int num_threads = 1);
  ~PhaseSolver();
  PhaseSolver(PhaseSolver&&) noexcept;
  /// Elements whose order does not change keep their matrices.
  void set_orders(std::vector<int> elem_order);

  /// The field of kind "phase". Throws ComputeError for impossible nodes (PhaseBoundary) and where the factorisation
  /// breaks down, UsageError unless there is one twist offset a hole or none.
  Field solve(const PhaseNodes& asked, const PhaseOptions& options, Report& report);
  /// Its energy. Throws as solve(), and ComputeError where a node lies outside the mesh (between a curve and its
  /// elements).
  PhaseEnergy energy(const PhaseNodes& asked, const PhaseOptions& options = {});
  /// Size of the condensed system for this order map.
  int num_unknowns(const std::vector<int>& elem_order) const;

 private:
  struct Parts;
  struct State;
  void factor();
  void measure_holes();
  State state(const PhaseNodes& asked, const PhaseOptions& options);
  std::unique_ptr<Parts> parts_;
};

/// One set of nodes.
Field solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked,
                  const PhaseOptions& options, Report& report);
Field solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked, Report& report);

}  // namespace quadrille::galerkin
