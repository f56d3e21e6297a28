#include <algorithm>

#include "base/assign_names.hpp"
#include "io/cad_face_io.hpp"
#include "io/instantiate_io.hpp"

namespace quadrille::io {

namespace {

double least(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::min_element(values.begin(), values.end());
}

void describe_edges(Archive& archive, const char* name, std::vector<QuadBoundaryEdge>& edges) {
  archive.field(name, edges, [](Archive& a, QuadBoundaryEdge& edge) {
    a.field("elem", edge.elem, {"", "element"});
    a.field("side", edge.side, {"", "side 0 to 3"});
    a.field("curve", edge.curve, {"", "CAD curve"});
  });
}

}  // namespace

void describe(Archive& archive, QuadMesh& mesh) {
  describe_face(archive, mesh.face);
  archive.field("order", mesh.order, {"", "shape order N"});
  archive.field("nodes", mesh.nodes, {"length", "relative to face.origin"});
  archive.field("elem_nodes", mesh.elem_nodes, {"", "(N+1)^2 nodes per element, xi1 fastest"});
  archive.field("elem_block", mesh.elem_block, {"", "block of each element"});
  archive.field("elem_jacobian_bound", mesh.elem_jacobian_bound, {"length^2", "proved lower bound of det J"});
  archive.field("elem_scaled_jacobian", mesh.elem_scaled_jacobian, {"1", "least sampled scaled Jacobian"});
  if (archive.has("elem_edge_ratio")) {
    archive.field("elem_edge_ratio", mesh.elem_edge_ratio, {"1", "longest over shortest side"});
    archive.field("elem_area_jump", mesh.elem_area_jump, {"1", "greatest ratio of the areas of neighbours"});
    archive.field("elem_node_distance", mesh.elem_node_distance, {"length", "least distance of neighbouring nodes"});
  }
  describe_edges(archive, "boundary_edges", mesh.boundary_edges);
  if (archive.is_reading() ? archive.has("interface_edges") : !mesh.interface_edges.empty())
    describe_edges(archive, "interface_edges", mesh.interface_edges);
  describe_open_curves(archive, mesh.open_curves);
  archive.field("block_names", mesh.block_names, {"", "name of each block"});
  if (archive.has("unnamed_blocks"))
    archive.field("unnamed_blocks", mesh.unnamed_blocks,
                  {"", "blocks whose name is made from their number, ascending"});
  else
    mesh.unnamed_blocks = presumed_numbered_names(mesh.block_names, "block");
  if (archive.is_reading() ? archive.has("block_region") : !mesh.block_region.empty())
    archive.field("block_region", mesh.block_region, {"", "region of each block"});
  archive.field("num_irregular", mesh.num_irregular, {"", "interior irregular nodes of the layout"});
  if (archive.has("least_jacobian_bound"))
    archive.field("least_jacobian_bound", mesh.least_jacobian_bound, {"length^2", "least of elem_jacobian_bound"});
  else
    mesh.least_jacobian_bound = least(mesh.elem_jacobian_bound);
  if (archive.has("is_valid")) archive.field("is_valid", mesh.is_valid, {"", "whether every element is proved valid"});
}

template QuadMesh read_stage(const InputFile&);
template std::string stage_bytes(const QuadMesh&);

}  // namespace quadrille::io
