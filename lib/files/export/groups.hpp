#pragma once
// Named groups, as solvers address them: boundaries, interfaces and regions by name. Curves, and blocks, of equal name
// are one group; curves without a name are called curve_<number>; all blocks without a given name are one region,
// "domain", or have the name of their region of the face.

#include <string>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct Groups {
  std::vector<std::string> boundary_names;   ///< in the order of their first curves
  std::vector<std::string> interface_names;  ///< of the curves that lie between elements and have no boundary's name
  std::vector<int> curve2boundary;           ///< by CAD curve: interfaces are numbered after the boundaries
  std::vector<std::string> region_names;     ///< in the order of their first blocks
  std::vector<int> block2region;             ///< by block
  std::vector<bool> is_region_named;         ///< by region: the name was given

  int num_boundaries() const { return static_cast<int>(boundary_names.size()); }
  int num_interfaces() const { return static_cast<int>(interface_names.size()); }
  int num_regions() const { return static_cast<int>(region_names.size()); }
};

/// The region of the blocks without a name is "domain", followed by as many "_" as are necessary to differ from all
/// given names.
Groups mesh_groups(const QuadMesh& mesh);

/// Whether a curve lies between elements: an interface that is not open.
std::vector<bool> inner_curves(const QuadMesh& mesh);

/// The edges on interfaces, each once: from the side whose curve has the lower number.
std::vector<QuadBoundaryEdge> interface_edges_once(const QuadMesh& mesh);

/// The region of each block: its name, or as in mesh_groups.
std::vector<std::string> region_of_blocks(const CadFace& face, const std::vector<int>& block_region,
                                          std::vector<std::string> block_names, const std::vector<int>& unnamed_blocks);

/// Gives the name block_<number> to each block without a name of its own (it has none, or that of the face or of its
/// region), so that it becomes a region of its own.
void separate_blocks(const CadFace& face, const std::vector<int>& block_region, std::vector<std::string>& block_names,
                     std::vector<int>& unnamed_blocks);

/// The same of a mesh or a layout.
template <typename Stage>
std::vector<std::string> region_of_blocks(const Stage& stage) {
  return region_of_blocks(stage.face, stage.block_region, stage.block_names, stage.unnamed_blocks);
}
template <typename Stage>
void separate_blocks(Stage& stage) {
  separate_blocks(stage.face, stage.block_region, stage.block_names, stage.unnamed_blocks);
}

}  // namespace quadrille::exports
