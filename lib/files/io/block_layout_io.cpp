#include "io/describe.hpp"

namespace quadrille::io {

namespace {

void describe_block_sides(Archive& archive, std::vector<std::array<HalfEdge, 4>>& block2arcs) {
  std::vector<std::array<int, 4>> codes;
  for (const auto& [s0, s1, s2, s3] : block2arcs)
    codes.push_back({file_code(s0), file_code(s1), file_code(s2), file_code(s3)});
  archive.field("block2arcs", codes, {"", "side k: arc a forwards, or -1-a backwards"});
  block2arcs.clear();
  for (const auto& [c0, c1, c2, c3] : codes)
    block2arcs.push_back({half_edge_of_code(c0), half_edge_of_code(c1), half_edge_of_code(c2), half_edge_of_code(c3)});
}

}  // namespace

void describe(Archive& archive, BlockLayout& layout) {
  describe_face(archive, layout.face);
  describe_nurbs(archive, "splines", layout.splines);
  describe_graph(archive, layout.nodes, layout.arcs);
  describe_open_curves(archive, layout.open_curves);
  archive.field("block2nodes", layout.block2nodes, {"", "nodes of each block, counter-clockwise"});
  describe_block_sides(archive, layout.block2arcs);
  archive.field("arc_chord", layout.arc_chord, {"", "chord of each arc"});
  archive.field("block_jacobian_bound", layout.block_jacobian_bound,
                {"length^2", "least Bernstein bound of det J of the block as one order-8 quad"});
  archive.later_field("block_scaled_jacobian", layout.block_scaled_jacobian,
                      {"1", "least scaled Jacobian of the block as one order-8 quad"});
  archive.later_field("block_boundary_distance", layout.block_boundary_distance,
                      {"length", "greatest distance of the boundary of that quad from the CAD curves"});
  describe_blocks(archive, layout.block_names, layout.unnamed_blocks, layout.block_region);
}

}  // namespace quadrille::io
