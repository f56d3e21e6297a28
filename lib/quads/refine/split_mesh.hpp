#pragma once
// One attempt at a mesh: the counts and divisions of all arcs, layers and lines, and the measured elements.

#include <optional>
#include <vector>

#include "base/report.hpp"
#include "growth/line_intervals.hpp"
#include "growth/smooth_walls.hpp"
#include "layers/wall_layers.hpp"
#include "model/quad_mesh.hpp"
#include "refine/divide_arcs.hpp"
#include "refine/refine_options.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/length_limits.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

/// The data that every attempt at a valid mesh has in common.
struct SplitRequest {
  const RefineOptions& options;
  sizing::SizeField sizes;
  double tolerance;        ///< of the boundary, a length
  DivideOptions division;  ///< with what splines that were replaced (CadFace::fit_distance) leave of the tolerance
  sizing::LengthLimits limits = {};
  int max_elements = 0;  ///< of divided arcs: more are refused
  bool limits_growth = false;
  Report* report = nullptr;
  const Progress::Part* attempt = nullptr;
  const struct SplitMesh* last = nullptr;  ///< of the last attempt, from which is taken what has not changed
};

/// A measured mesh and the plans from which it was made.
struct SplitMesh {
  QuadMesh mesh;
  std::vector<sizing::ChordPlan> plans;
  double tolerance = 0;  ///< with which arcs were divided
  bool has_equal_parameters = false;
  sizing::ArcDivisions divisions;
  std::optional<layers::WallPlan> walls;
  std::optional<growth::GrowthOutcome> growth;
  growth::LinePlan lines;
  int doublings = 0;         ///< of counts beyond the prescribed sizes, until the mesh was valid
  int shortened_chords = 0;  ///< chords with length limits
};

/// The mesh of the result's divisions, layers and lines. `known`: elements that are the same keep their measures.
QuadMesh measured_mesh(const sizing::MeasuredLayout& measured, const SplitRequest& request, const SplitMesh& result,
                       const QuadMesh* known);

/// `coarse`: counts of chords outside the chosen blocks. Throws as refine.
SplitMesh split(const sizing::MeasuredLayout& measured, const SplitRequest& request,
                const std::vector<sizing::ChordCount>& coarse);

}  // namespace quadrille::refine
