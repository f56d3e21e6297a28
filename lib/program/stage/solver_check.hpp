#pragma once
// --check-for: whether a program takes the mesh that it reads in a format, by its own measures and limits.

#include <string>
#include <vector>

#include "base/run.hpp"
#include "export/format_table.hpp"
#include "export/patches.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"
#include "stage/solver_table.hpp"

namespace quadrille::stage {

enum class ElementKind { quads, hexahedra };

/// Throws UsageError if the solver does not read the format.
void require_format_of_solver(const SolverRow& solver, const std::string& format);

/// Why the solver does not read elements of this kind and order, and what to do; empty if it does.
std::string order_refusal(const SolverRow& solver, ElementKind kind, int order);

struct SolverRequest {
  const SolverRow& solver;
  const exports::ExportFormat& format;
  std::vector<exports::PatchType> patch_types{};  ///< those decide which patches are cyclic
  double scale = 1;                               ///< written lengths over those of the mesh
};

/// Measures the mesh as the solver has it that reads the format, and reports the worst value of each measure. Warns of
/// those that reach a limit. Throws ComputeError with element, place, value, limit and remedy if one reaches the limit
/// of failure, and for an order that the solver does not read.
void check_for_solver(const QuadMesh& mesh, const SolverRequest& request, Run& run);
void check_for_solver(const HexMesh& mesh, const SolverRequest& request, Run& run);

}  // namespace quadrille::stage
