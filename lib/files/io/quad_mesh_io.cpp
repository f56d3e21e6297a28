#include <algorithm>

#include "io/describe.hpp"

namespace quadrille::io {

namespace {

double least(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::min_element(values.begin(), values.end());
}

void describe_edge(Archive& archive, QuadBoundaryEdge& edge) {
  archive.field("elem", edge.elem, {"", "element"});
  archive.field("side", edge.side, {"", "side 0 to 3"});
  archive.field("curve", edge.curve, {"", "CAD curve"});
}

void describe_stretch(Archive& archive, SymmetricTensor& stretch) {
  archive.field("xx", stretch.xx, {"1", "tensor of determinant 1"});
  archive.field("xy", stretch.xy, {"1", "of xy and yx"});
  archive.field("yy", stretch.yy, {"1", "tensor of determinant 1"});
}

}  // namespace

void describe(Archive& archive, QuadMesh& mesh) {
  describe_face(archive, mesh.face);
  archive.field("order", mesh.order, {"", "shape order N"});
  archive.field("nodes", mesh.nodes, {"length", "relative to face.origin"});
  archive.nonempty_field("space_nodes", mesh.space_nodes,
                         Doc{"length", "on the surface, in the coordinates of the file"});
  archive.field("elem_nodes", mesh.elem_nodes, {"", "(N+1)^2 nodes per element, xi1 fastest"});
  archive.field("elem_block", mesh.elem_block, {"", "block of each element"});
  archive.field("elem_jacobian_bound", mesh.elem_jacobian_bound, {"length^2", "proved lower bound of det J"});
  archive.field("elem_scaled_jacobian", mesh.elem_scaled_jacobian, {"1", "least sampled scaled Jacobian"});
  if (archive.has("elem_edge_ratio")) {
    archive.field("elem_edge_ratio", mesh.elem_edge_ratio, {"1", "longest over shortest side"});
    archive.field("elem_area_jump", mesh.elem_area_jump, {"1", "greatest ratio of the areas of neighbours"});
    archive.field("elem_node_distance", mesh.elem_node_distance, {"length", "least distance of neighbouring nodes"});
  }
  archive.nonempty_field("elem_prescribed_length", mesh.elem_prescribed_length,
                         {"length", "prescribed edge length; 0: by wall layers"});
  archive.nonempty_field("elem_prescribed_stretch", mesh.elem_prescribed_stretch, describe_stretch);
  archive.field("boundary_edges", mesh.boundary_edges, describe_edge);
  archive.nonempty_field("interface_edges", mesh.interface_edges, describe_edge);
  describe_open_curves(archive, mesh.open_curves);
  describe_blocks(archive, mesh.block_names, mesh.unnamed_blocks, mesh.block_region);
  archive.field("num_irregular", mesh.num_irregular, {"", "inner irregular nodes, also of rings around tips"});
  if (!archive.has("least_jacobian_bound")) mesh.least_jacobian_bound = least(mesh.elem_jacobian_bound);
  archive.later_field("least_jacobian_bound", mesh.least_jacobian_bound, {"length^2", "least of elem_jacobian_bound"});
  archive.later_field("is_valid", mesh.is_valid, {"", "whether every element is proved valid"});
}

}  // namespace quadrille::io
