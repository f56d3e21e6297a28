#pragma once
// The programs of --check-for, one row each: the formats and orders that they read, where they evaluate det J, and the
// limits of their measures, with the sources (formats/check-for.md has them for users).

#include <optional>
#include <string_view>
#include <vector>

#include "mesh/cell_quality.hpp"
#include "mesh/straight_cells.hpp"

namespace quadrille::stage {

enum class SolverMeasure {
  face_angle,
  boundary_face_angle,
  skewness,
  aspect_ratio,
  pyramid,
  plane_deviation,
  volume_ratio,
  face_offset,
  gradient_condition,
  jacobian_ratio,
  relative_jacobian,
  jacobian
};

struct SolverMeasureRow {
  SolverMeasure measure;
  std::string_view name;        ///< in reports and messages; blanks are _ in reports
  std::string_view unit;        ///< behind the value
  bool is_least_worst = false;  ///< small values are bad, else great ones
  /// Of straight cells; nullptr: of det J, a value of each element.
  std::vector<mesh::CellSample> (*of_cells)(const mesh::StraightCells&, const mesh::CellGeometry&) = nullptr;
  std::string_view remedy;
};

const SolverMeasureRow& solver_measure(SolverMeasure measure);

/// Reached by the worst value: a warning, or no file is written.
struct SolverLimit {
  SolverMeasure measure;
  std::optional<double> warning{}, failure{};
};

struct SolverRow {
  std::string_view name;                  ///< for --check-for
  std::string_view title;                 ///< in messages
  std::vector<std::string_view> formats;  ///< of quadexport that it reads
  std::vector<SolverLimit> limits;
  int max_order = 20, max_hex_order = 20;  ///< of quads, 0: it computes on volumes alone, and hexahedra
  /// Coordinates of the grid of points at which it evaluates det J of an element of this order.
  std::vector<double> (*points)(int order) = nullptr;
  mesh::CellCentre centre = mesh::CellCentre::volume;  ///< of straight cells
};

const std::vector<SolverRow>& solver_rows();

/// The row of a program by its name for --check-for; nullptr if no program has this name.
const SolverRow* find_solver(std::string_view name);

}  // namespace quadrille::stage
