#pragma once
// Which element holds a point, and where: a search grid over curved elements.

#include <vector>

#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille {

struct Location {
  int elem = -1;  ///< -1: outside the mesh
  Vec2 xi;
};

class Locator {
 public:
  /// `maps` must outlive the locator.
  Locator(const TriMesh& mesh, const std::vector<TriMap>& maps);
  /// The element that holds x, the lowest number where several do; points within 1e-10 of an element's reference
  /// triangle count as inside.
  Location find(Vec2 x) const;

 private:
  const std::vector<TriMap>* maps_;
  Vec2 lower_, cell_;
  int nx_ = 1, ny_ = 1;
  std::vector<int> offsets_, values_;  ///< search grid cell -> elements whose hull touches it
};

}  // namespace quadrille
