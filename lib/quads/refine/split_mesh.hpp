#pragma once
// One attempt at a mesh: the counts and divisions of all arcs, layers and lines, and the measured elements.

#include <memory>
#include <optional>
#include <vector>

#include "base/report.hpp"
#include "growth/smooth_walls.hpp"
#include "mesh/boundary_distance.hpp"
#include "mesh/mesh_score.hpp"
#include "model/quad_mesh.hpp"
#include "refine/chord_division.hpp"
#include "refine/length_limits.hpp"
#include "refine/placed_vertices.hpp"
#include "refine/refine_options.hpp"
#include "sizing/curve_sizes.hpp"
#include "sizing/hole_rings.hpp"

namespace quadrille::refine {

class VertexRelaxation;

/// The data that all attempts have in common.
struct SplitRequest {
  const RefineOptions& options;
  const sizing::MeasuredLayout& equal;    ///< lines connect equal fractions of the arcs
  const sizing::MeasuredLayout& aligned;  ///< lines are nearly normal to the arcs (refine/align_chords)
  sizing::SizeField sizes;
  mesh::ScoreLimits limits;  ///< above which remedies apply
  Report& report;
  std::vector<sizing::HoleRing> rings = {};
  sizing::SizeField sizes_at_bends = sizing::sizes_at_bends(equal.blocks().face, sizes);  ///< of vertices that move
};

/// What remedies change from one attempt to the next.
struct SplitSettings {
  bool limits_growth = false;
  bool is_aligned = false;
  std::vector<sizing::ChordCount> counts = {};  ///< of chords without a prescribed one, in place of their sizes
  double tolerance = 0;                         ///< of the divisions of the boundary, a length
  LengthLimits length_limits = {};
  int max_elements = 0;  ///< of divided arcs: more are refused
  int doublings = 0;     ///< of the counts of chords with elements that were not proved valid
};

/// A measured mesh and the plans from which it was made.
struct SplitMesh {
  SplitSettings settings;
  std::vector<sizing::ChordPlan> plans = {};
  sizing::ArcDivisions divisions = {};
  std::optional<layers::WallPlan> walls = {};
  std::optional<growth::GrowthOutcome> growth = {};
  growth::LinePlan lines = {};
  QuadMesh mesh = {};
  mesh::BoundaryDistance distance = {};
  mesh::MeshScore score = {};
  std::optional<PlacedVertices> vertices = {};        ///< where vertices begin, if known
  std::shared_ptr<VertexRelaxation> relaxation = {};  ///< by which vertices were moved
};

/// The settings that the options prescribe.
SplitSettings first_settings(const SplitRequest& request);

/// The layout with the lines of these settings.
const sizing::MeasuredLayout& layout_of(const SplitRequest& request, const SplitSettings& settings);

/// By SizeRule::error vertices are relaxed.
DivideOptions divide_options(const SplitRequest& request, const SplitSettings& settings);

/// For the layers along walls.
layers::WallInput wall_input(const SplitRequest& request, const SplitSettings& settings);

/// `last`: another attempt, from which is taken what has not changed; or none. Throws as refine.
SplitMesh split(const SplitRequest& request, const SplitSettings& settings, const SplitMesh* last);

/// Makes the mesh of the divisions, layers and lines of `result`, and measures its elements; those that `known` has
/// keep their measures.
void sample_mesh(const SplitRequest& request, const QuadMesh* known, SplitMesh& result);

/// Measures the mesh, whose elements and distance are measured.
void set_score(const SplitRequest& request, SplitMesh& result);

/// By element: whether a chord that layers divide passes it. Such elements are thin on purpose, also in the blocks
/// behind the layers, through which the chord runs on. Empty: there are no layers.
std::vector<bool> elements_on_layered_chords(const BlockLayout& blocks, const SplitMesh& split);

/// Of all elements, at their middles; 0 on the chords that layers divide.
void set_prescribed_lengths(const SplitRequest& request, SplitMesh& split);

}  // namespace quadrille::refine
