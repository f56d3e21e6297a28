#pragma once
// Finds the element that contains a point: a search grid over curved elements, and a walk from an element near by.

#include <array>
#include <cmath>
#include <vector>

#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::mesh {

struct Location {
  int elem = -1;  ///< -1: outside the mesh
  Vec2 xi;
};

/// Distance of a point from the reference triangle, in barycentric coordinates: <= 0 inside.
inline double outside_reference(Vec2 xi) { return std::fmax(std::fmax(-(1 + xi.x), -(1 + xi.y)), xi.x + xi.y) / 2; }

class Locator {
 public:
  /// `maps` must outlive the locator.
  Locator(const TriMesh& mesh, const std::vector<spectral::TriMap>& maps);
  /// The element that contains x, the lowest number if several do; points within 1e-10 of an element's reference
  /// triangle count as inside. If none does, the element that is nearest within 1e-14 diameters: round-off is more than
  /// 1e-10 of the elements in a corner's fan, and a point on their common edge may lie outside both.
  Location find(Vec2 x) const { return find(x, round_off_); }
  /// The same with another length in place of 1e-14 diameters; only elements whose boxes contain x count.
  Location find(Vec2 x, double beside) const;
  /// From the box around an element; no point of the element is nearer.
  double distance_to_box(int elem, Vec2 x) const;

 private:
  struct Box {
    Vec2 lower, upper;
  };
  std::array<int, 2> cell_of(Vec2 x) const;
  bool is_in_box(int elem, Vec2 x) const;
  void fill_grid();

  const std::vector<spectral::TriMap>* maps_;
  std::vector<Box> boxes_;  ///< one per element, which it encloses with a margin
  double round_off_ = 0;    ///< a length
  Vec2 lower_, cell_;
  int nx_ = 1, ny_ = 1;
  std::vector<int> offsets_, values_;  ///< search grid cell -> elements whose box touches it, ascending
};

/// The element that contains x, found by steps from element to neighbour, always across the edge beyond which x lies
/// farthest; starts at `from`, whose xi is the first guess. Returns elem = -1 if the walk meets the boundary (the
/// domain may be concave), steps back to the previous element or takes more than 64 steps; only Locator::find can
/// decide that x lies outside. For x on an edge, returns the element that the walk reaches first. No allocation.
Location walk(const TriTopology& topology, const std::vector<spectral::TriMap>& maps, Vec2 x, Location from);

}  // namespace quadrille::mesh
