#pragma once
// The unit cross field with exactly the irregular nodes and corner valences asked for (phase-field.md): s of point 3 by
// one continuous Laplace solve, the twists of the holes by point 6.

#include <vector>

#include "base/report.hpp"
#include "model/phase_nodes.hpp"
#include "model/phase_terms.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille {

struct PhaseOptions {
  /// Added to the twists of least energy, one for each hole (loops 1, 2, ...); empty: none. Lines wind round a hole for
  /// ever where it is not 0.
  std::vector<int> twist_offsets;
};

/// phi = terms + s: e^(i phi) = v / |v|, phi / 4 the angle of the cross.
struct PhaseSolution {
  PhaseTerms terms;
  std::vector<int> elem_order;
  std::vector<int> coef_offsets;  ///< element e owns s[coef_offsets[e], coef_offsets[e+1])
  std::vector<double> s;          ///< orthogonal basis; twists included
  /// For each hole, counted from the data's own branch (field/phase_boundary.hpp), so only differences have a meaning:
  std::vector<double> best_twists;  ///< m* = -K^-1 r / (2 pi), real
  std::vector<int> twists;          ///< m
  /// Of lambda round each hole, (r + 2 pi K m)_j / 4: where it is not 0 the conformal map is only local (point 10).
  std::vector<double> periods;
  double twist_energy = 0;  ///< 2 pi^2 (m - m*)^T K (m - m*): what whole twists cost above real ones
  int num_unknowns = 0;     ///< of the condensed system
  double residual = 0;      ///< of the condensed system, relative to its right-hand side
};

/// Solves on `mesh` with order elem_order[e] on element e. Throws ComputeError for impossible nodes (PhaseBoundary) and
/// where the factorisation breaks down, UsageError unless there is one twist offset a hole or none. One factorisation
/// for each pair of s and the holes' harmonic measures.
PhaseSolution solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked,
                          const PhaseOptions& options, Report& report);
PhaseSolution solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked,
                          Report& report);

}  // namespace quadrille
