#pragma once
// Named groups, as solvers address them: boundaries by name, regions by name. Curves, and blocks, of equal name are one
// group; curves without a name are called curve_<number>; all blocks without a given name are one region, "domain".

#include <string>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct Groups {
  std::vector<std::string> boundary_names;  ///< in the order of their first curves
  std::vector<int> curve2boundary;          ///< by CAD curve
  std::vector<std::string> region_names;    ///< in the order of their first blocks
  std::vector<int> block2region;            ///< by block
  std::vector<bool> is_region_named;        ///< by region: the name was given

  int num_boundaries() const { return static_cast<int>(boundary_names.size()); }
  int num_regions() const { return static_cast<int>(region_names.size()); }
};

/// The region of the blocks without a name is "domain", followed by as many "_" as are necessary to differ from all
/// given names.
Groups mesh_groups(const QuadMesh& mesh);

/// The region of each block: its name, or "domain" as in mesh_groups.
std::vector<std::string> region_of_blocks(std::vector<std::string> block_names, const std::vector<int>& unnamed_blocks);

/// Gives the name block_<number> to each block without a name of its own (it has none, or that of the face), so that it
/// becomes a region of its own.
void separate_blocks(std::vector<std::string>& block_names, std::vector<int>& unnamed_blocks,
                     const std::string& face_name);

}  // namespace quadrille::exports
