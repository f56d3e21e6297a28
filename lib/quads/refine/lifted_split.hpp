#pragma once
// From the mesh of a chart to the mesh on the surface (lib/method.md §12). All of refine works in the chart; what
// exists in space alone is measured here: the proof of elements and their distance from the surface. Where one fails,
// shorter edges are prescribed and the mesh is made again; but not for the distance of elements at a tip, which only
// falls with their length (refine/surface_tips): at last, they become so small by rings of elements around them.

#include <memory>
#include <optional>
#include <vector>

#include "mesh/lifted_mesh.hpp"
#include "refine/split_mesh.hpp"
#include "refine/swapped_ends.hpp"

namespace quadrille::refine {

/// Times that a mesh is made again with shorter edges, at most, and as often again to approach a bend.
inline constexpr int max_lifts = 5;
/// Of these, the slow ones in a row after which the surface is taken to have a kink.
inline constexpr int max_slow_lifts = 2;

/// A lifted mesh, measured in space; prescribed lengths are lengths there.
struct LiftedMesh {
  QuadMesh mesh;
  mesh::SurfaceDistance distance;
  std::vector<bool> is_at_tip = {};  ///< elements as near to a tip of the surface as they are long
  bool is_smooth = true;             ///< false: shorter edges hardly helped, as at a kink of the surface

  /// The element that is farthest from the surface of those that are at no tip; -1: there are none.
  int farthest() const;
  double farthest_distance() const { return farthest() < 0 ? 0 : distance.elem[farthest()]; }
};

/// What counts of a surface, beside its chart.
struct SurfaceTraits {
  std::vector<Vec3> tips = {};  ///< in space (refine/surface_tips)
  std::optional<SpaceMirror> end_mirror = {};
};

LiftedMesh lifted(const mesh::ChartMap& map, QuadMesh mesh, const SurfaceTraits& surface, Progress* progress);

/// Sources of the edge lengths with which elements that are not proved would be, and all elements at no tip well within
/// `tolerance` (a length) of the surface, if their distance fell with this power of their length. Lengths are in space.
/// Empty: the mesh is as it must be.
std::vector<sizing::SizeSegment> finer_sizes(const mesh::ChartMap& map, const LiftedMesh& lifted,
                                             const sizing::SizeField& sizes, double tolerance, int power);

/// Whether fewer elements of `a` are not proved or, if as many are, those at no tip are nearer to the surface.
bool is_nearer(const LiftedMesh& a, const LiftedMesh& b);

/// Whether edges that finer_sizes made shorter hardly helped: as many elements are not proved, or the distance fell
/// little more than their length.
bool fell_slowly(const LiftedMesh& last, const LiftedMesh& next, double tolerance, int power);

/// Whether the distance fell, and may fall slowly without a kink: in the element that is farthest from the surface,
/// nodes are farther apart than the radius of curvature there, and not after this many more rounds.
bool is_resolving_bend(const mesh::ChartMap& map, const LiftedMesh& last, const LiftedMesh& next, int num_rounds);

/// The power to expect in a round: N + 1 of a smooth surface. Elements that are too far after a round are where
/// curvatures jump, as at the knots of a cubic surface: then 2.
inline int expected_power(int round, int order) { return round == 0 ? order + 1 : 2; }

/// Adds rings around tips at which elements of `mesh`, in the chart, lifted `there`, are farther than the tolerance
/// from the surface (refine/tip_rings): as many as lower that of elements at the tip to it, and of the least width with
/// which their own distance is below it, too. None that make more elements unproved, or elements more than
/// `max_elements`.
void add_tip_rings(const mesh::ChartMap& map, const SurfaceTraits& surface, double tolerance, int max_elements,
                   QuadMesh& mesh, LiftedMesh& there, Progress* progress);

/// Reports the distance (surface.*), and warns if it is above the tolerance, a length; neither if that is infinite.
void report_surface(const LiftedMesh& lifted, double tolerance, Report& report);

}  // namespace quadrille::refine
