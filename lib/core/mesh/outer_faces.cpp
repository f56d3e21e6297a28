#include "mesh/outer_faces.hpp"

#include <map>
#include <utility>

#include "mesh/side_key.hpp"

namespace quadrille::mesh {

namespace {

/// The number of each node that is used, in the order of their first use.
class UsedNodes {
 public:
  UsedNodes(const HexMesh& mesh, QuadMesh& outer) : mesh_(mesh), outer_(outer), numbers_(mesh.nodes.size(), -1) {}

  int operator()(int node) {
    if (numbers_[node] < 0) {
      numbers_[node] = static_cast<int>(outer_.space_nodes.size());
      outer_.space_nodes.push_back(mesh_.nodes[node]);
    }
    return numbers_[node];
  }

 private:
  const HexMesh& mesh_;
  QuadMesh& outer_;
  std::vector<int> numbers_;
};

}  // namespace

std::vector<Border> borders(const QuadMesh& mesh, const std::vector<int>& elem_group) {
  std::map<std::pair<int, int>, ElementSide> seen;
  std::vector<Border> result;
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int side = 0; side < 4; ++side) {
      const auto [known, is_new] = seen.try_emplace(side_key(mesh, e, side), ElementSide{e, side});
      if (!is_new && elem_group[known->second.elem] != elem_group[e]) result.push_back({known->second, {e, side}});
    }
  return result;
}

QuadMesh outer_faces(const HexMesh& mesh) {
  QuadMesh outer;
  outer.face.length_unit = mesh.length_unit;
  outer.order = mesh.order;
  outer.is_valid = mesh.is_valid;
  outer.least_jacobian_bound = mesh.least_jacobian_bound;
  UsedNodes number(mesh, outer);
  std::vector<int> quad_group;
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g) {
    const HexFaceGroup& group = mesh.face_groups[g];
    for (std::size_t f = 0; f < group.elems.size() && !group.is_interface; ++f) {
      const int elem = group.elems[f];
      for (const int local : hex_face_nodes(mesh.order, group.faces[f]))
        outer.elem_nodes.push_back(
            number(mesh.elem_nodes[static_cast<std::size_t>(elem) * mesh.nodes_per_elem() + local]));
      outer.elem_block.push_back(mesh.quad_block[elem % mesh.num_quads]);
      outer.elem_jacobian_bound.push_back(mesh.elem_jacobian_bound[elem]);
      outer.elem_scaled_jacobian.push_back(mesh.elem_scaled_jacobian[elem]);
      quad_group.push_back(static_cast<int>(g));
    }
  }
  for (std::size_t block = 0; block < mesh.block_region.size(); ++block)
    outer.block_names.push_back(mesh.region_names[mesh.block_region[block]]);
  outer.nodes.resize(outer.space_nodes.size());
  for (const auto& [first, second] : borders(outer, quad_group))
    for (const ElementSide& at : {second, first})
      outer.boundary_edges.push_back({at.elem, at.side, quad_group[at.elem]});
  return outer;
}

}  // namespace quadrille::mesh
