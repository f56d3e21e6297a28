#include "io/describe.hpp"

namespace quadrille::io {

namespace {

/// Rows of the matrix, then the shift.
void describe_motion(Archive& archive, SpaceMotion& motion) {
  std::array<double, 12> numbers{};
  for (int r = 0; r < 3; ++r) {
    numbers[4 * r] = motion.matrix[r].x, numbers[4 * r + 1] = motion.matrix[r].y,
                numbers[4 * r + 2] = motion.matrix[r].z;
    numbers[4 * r + 3] = r == 0 ? motion.shift.x : r == 1 ? motion.shift.y : motion.shift.z;
  }
  archive.field("motion", numbers, {"1, length", "rows of (matrix, shift) of the motion"});
  for (int r = 0; r < 3; ++r) motion.matrix[r] = {numbers[4 * r], numbers[4 * r + 1], numbers[4 * r + 2]};
  motion.shift = {numbers[3], numbers[7], numbers[11]};
}

void describe_group(Archive& archive, HexFaceGroup& group) {
  archive.field("name", group.name, {"", "of the boundary or interface"});
  archive.field("elems", group.elems, {"", "element of each face"});
  archive.field("faces", group.faces, {"", "face 0 to 5 of the element"});
  archive.field("is_interface", group.is_interface, {"", "between two regions"});
  archive.field("periodic_with", group.periodic_with, {"", "group of the images; -1: none"});
  describe_motion(archive, group.motion);
}

}  // namespace

void describe(Archive& archive, HexMesh& mesh) {
  archive.field("length_unit", mesh.length_unit, {"", "of the CAD file"});
  archive.field("diameter", mesh.diameter, {"length", "diagonal of the box of the nodes"});
  archive.field("order", mesh.order, {"", "shape order N"});
  archive.field("num_quads", mesh.num_quads, {"", "elements of a layer"});
  archive.field("nodes", mesh.nodes, {"length", "in the coordinates of the CAD model"});
  archive.field("elem_nodes", mesh.elem_nodes, {"", "(N+1)^3 nodes per element, xi1 fastest, xi3 slowest"});
  archive.field("quad_block", mesh.quad_block, {"", "block of each element of a layer"});
  archive.field("block_region", mesh.block_region, {"", "region of each block"});
  archive.field("region_names", mesh.region_names, {"", "of the regions"});
  archive.field("face_groups", mesh.face_groups, describe_group);
  archive.field("elem_jacobian_bound", mesh.elem_jacobian_bound, {"length^3", "proved lower bound of det J"});
  archive.field("elem_scaled_jacobian", mesh.elem_scaled_jacobian, {"1", "least sampled scaled Jacobian"});
  archive.field("least_jacobian_bound", mesh.least_jacobian_bound, {"length^3", "least of elem_jacobian_bound"});
  archive.field("is_valid", mesh.is_valid, {"", "whether every element is proved valid"});
}

}  // namespace quadrille::io
