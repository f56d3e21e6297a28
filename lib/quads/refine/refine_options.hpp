#pragma once
// What users prescribe for the mesh of a layout (refine/refine).

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "layers/wall_spec.hpp"
#include "prescribe/boundary_counts.hpp"

namespace quadrille::refine {

/// The tolerance that elements of this order meet at the usual sizes without being divided much further, in diameters:
/// 5e-3, 5e-4, 2e-5 at orders 1, 2, 3, then 5e-7.
double default_geometry_tol(int order);

/// The shape of edges on no CAD curve (refine/inner_edges).
enum class InnerEdges {
  straight,  ///< on their chords where elements allow it
  curved,    ///< as the blocks are
  fade,      ///< the curvature of the blocks, halved from row to row behind a curved boundary
};
constexpr auto enum_names(InnerEdges) { return std::to_array({"straight", "curved", "fade"}); }

/// The goal to which vertices are moved.
enum class Relax {
  size,   ///< edges have the prescribed lengths (refine/relax_sizes)
  shape,  ///< elements have the angles of rectangles, with the lengths that they have (refine/relax_sizes)
  none,   ///< vertices are not moved
};
constexpr auto enum_names(Relax) { return std::to_array({"size", "shape", "none"}); }

/// Throws UsageError if the text is not the name of a goal.
Relax parse_relax(const std::string& text);

/// Rows of elements around small holes (sizing/hole_rings).
enum class Rings {
  automatic,  ///< with SizeRule::error, without chosen blocks or lines of symmetry
  none
};
constexpr auto enum_names(Rings) { return std::to_array({"auto", "none"}); }

/// The least progress of a sweep, of the energy, where vertices are put in place, and where they only have to be near
/// that: the resolution ratio is then true to about 1 %.
inline constexpr double fine_progress = 1e-8, coarse_progress = 1e-3;

/// c = |c| e^(4 i angle) at a position, as a vector, by which sides of elements shall follow a direction or a right
/// angle to it (refine/size_energy); |c| is the weight, 0 where there is no direction.
using PrescribedDirections = std::function<Vec2(Vec2)>;

struct RefineOptions {
  double size = 0;               ///< prescribed edge length in file units; 0: diameter / 20
  int order = 4;                 ///< shape order N, 1..20
  double geometry_tol = 0;       ///< greatest distance of mesh boundary and CAD curve, in diameters; 0: by the order
  bool keeps_to_surface = true;  ///< geometry_tol also limits distances of elements from the surface of a curved face
  bool allow_invalid = false;    ///< return the mesh, marked as not valid, also if elements are not proved
  std::optional<sizing::SizeField> size_field =
      {};  ///< prescribed edge lengths, in place of `size` (sizing/make_size_field)
  sizing::SizeRule size_rule = sizing::SizeRule::error;
  double good_resolution = 1.5;  ///< no counts are sought that lower the error if the resolution ratio is not above it
  std::vector<sizing::ChordCount> counts = {};  ///< prescribed counts of single chords, in place of their sizes
  std::vector<prescribe::BoundaryCount> boundary_counts = {};  ///< and along boundaries (prescribe/boundary_counts)
  std::vector<prescribe::EndGrading> end_gradings = {};  ///< lengths at the ends of boundaries (prescribe/end_grading)
  double end_growth = 1.2;                               ///< and the greatest growth from there, > 1
  std::vector<layers::WallSpec> walls = {};              ///< layers along boundaries (layers/wall_layers)
  std::vector<int> blocks = {};    ///< chords through these only are refined (refine/chosen_blocks); empty: all
  double min_scaled_jacobian = 0;  ///< a mesh with a lower one is an error, 0 to 1; 0: none is
  /// Elements become shorter where blocks are so thin that the ratio of their sides would exceed this
  /// (refine/length_limits); 0: none do, else at least 1.
  double target_edge_ratio = 100;
  /// With walls, lines across blocks are smoothed, and counts raised, until adjacent edges along them differ by at most
  /// this factor (growth/limit_growth); 0: they are not, else above 1.
  double target_growth = 1.3;
  double max_edge_ratio = 0;   ///< a mesh with a higher one is an error, 0: none is, else at least 1
  int max_elements = 1000000;  ///< more are refused (sizing/element_limit)
  InnerEdges inner_edges = InnerEdges::straight;
  Relax relax = Relax::size;
  Rings rings = Rings::automatic;
  int relax_sweeps = 200;  ///< greatest number, 0..1000
  double least_progress = fine_progress;
  std::vector<std::string> symmetry =
      {};  ///< patterns of the names of curves at lines of symmetry (sizing/halved_blocks)
  PrescribedDirections directions = {};  ///< of the sides of elements; empty: none
  int levels = 0;         ///< at the end every element becomes 2^levels x 2^levels (mesh/nested_quads), 0..10
  void validate() const;  ///< throws UsageError
};

}  // namespace quadrille::refine
