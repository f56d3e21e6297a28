#pragma once
// Named groups, as solvers address them: boundaries by name, regions by name. Curves, and blocks, of equal name are one
// group; curves without a name are called curve_<number>.

#include <string>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct Groups {
  std::vector<std::string> boundary_names;  ///< in the order of their first curves
  std::vector<int> curve2boundary;          ///< by CAD curve
  std::vector<std::string> region_names;    ///< in the order of their first blocks
  std::vector<int> block2region;            ///< by block
  std::vector<bool> is_region_named;        ///< by region: the name was given, not made from a block's number

  int num_boundaries() const { return static_cast<int>(boundary_names.size()); }
  int num_regions() const { return static_cast<int>(region_names.size()); }
};

Groups mesh_groups(const QuadMesh& mesh);

}  // namespace quadrille::exports
