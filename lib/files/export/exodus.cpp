#include <array>
#include <cstdint>
#include <string>

#include "export/exodus_model.hpp"
#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// Elements by region, numbered block by block from 1: `block_of` and `nodes_of` of an element.
template <typename BlockOf, typename NodesOf>
std::vector<std::int32_t> add_blocks(const NameList& names, const std::string& type, int num_elems,
                                     const BlockOf& block_of, const NodesOf& nodes_of, ExodusModel& model) {
  std::vector<std::int32_t> numbers(num_elems);
  std::int32_t next = 0;
  for (std::size_t b = 0; b < names.size(); ++b) {
    ExodusBlock block{names[b], type, 0, {}};
    for (int elem = 0; elem < num_elems; ++elem) {
      if (block_of(elem) != static_cast<int>(b)) continue;
      const std::vector<int> nodes = nodes_of(elem);
      block.nodes_per_elem = static_cast<int>(nodes.size());
      for (const int node : nodes) block.nodes.push_back(node + 1);
      numbers[elem] = ++next;
    }
    if (!block.nodes.empty()) model.blocks.push_back(std::move(block));
  }
  return numbers;
}

/// Corners, middles of the sides after them, middle of the element.
std::vector<int> exodus_quad(const QuadMesh& mesh, int elem) {
  std::vector<int> nodes;
  for (int k = 0; k < mesh.order; ++k)
    for (int side = 0; side < 4; ++side) nodes.push_back(side_node(mesh, elem, side, k));
  if (mesh.order == 2) nodes.push_back(mesh.elem_nodes[elem * 9 + 4]);
  return nodes;
}

/// The places of the nodes in a grid of 3 x 3 x 3: corners, middles of the edges below, upright and above, the middle
/// of the element, middles of the faces: below, above, then low and high first and second coordinate.
constexpr std::array<int, 27> hex27_order{0,  2,  8,  6,  18, 20, 26, 24, 1,  5,  7,  3,  9, 11,
                                          17, 15, 19, 23, 25, 21, 13, 4,  22, 12, 14, 10, 16};

std::vector<int> exodus_hex(const HexMesh& mesh, int elem) {
  const int* own = &mesh.elem_nodes[elem * mesh.nodes_per_elem()];
  std::vector<int> nodes;
  if (mesh.order == 1)
    for (int corner = 0; corner < 8; ++corner) nodes.push_back(own[hex_corner_node(1, corner)]);
  else
    for (const int local : hex27_order) nodes.push_back(own[local]);
  return nodes;
}

std::vector<ExodusSideSet> named_sets(const NameList& names) {
  std::vector<ExodusSideSet> sets;
  for (const std::string& name : names) sets.push_back({name, {}, {}});
  return sets;
}

const WordRules exodus_names{{}, longest_exodus_name, false};

}  // namespace

Exported exodus(const QuadMesh& mesh, const Frame& frame) {
  const QuadMesh quads = split_to_quadratic(mesh);
  require_valid_pieces(quads, "Elements of Exodus");
  const Groups lines = lines_as_boundaries(mesh_groups(mesh));
  Exported exported;
  exported.is_binary = true;
  exported.add_loss(split_loss(mesh, quads));
  const PlainNames words = add_plain_names(lines, true, exodus_names, exported);
  ExodusModel model{"quadrilaterals of order " + std::to_string(quads.order), {{}, {}}, {}, {}};
  for (const Vec2 node : quads.nodes)
    for (int c = 0; c < 2; ++c) model.x[c].push_back(frame.at(node)[c]);
  const std::vector<std::int32_t> numbers = add_blocks(
      words.regions, quads.order == 1 ? "QUAD4" : "QUAD9", quads.num_elems(),
      [&](int elem) { return lines.block2region[quads.elem_block[elem]]; },
      [&](int elem) { return exodus_quad(quads, elem); }, model);
  model.side_sets = named_sets(words.boundaries);
  const std::vector<QuadBoundaryEdge> inner = interface_edges_once(quads);
  for (const auto* edges : {&quads.boundary_edges, &inner})
    for (const QuadBoundaryEdge& e : *edges) {
      ExodusSideSet& set = model.side_sets[lines.curve2boundary[e.curve]];
      set.elems.push_back(numbers[e.elem]), set.sides.push_back(e.side + 1);
    }
  exported.bytes = exodus_file(std::move(model));
  return exported;
}

/// Faces have the numbers of HexMesh: the sides of the quad, bottom, top.
Exported exodus(const HexMesh& mesh) {
  const HexNumbering numbering = number_hexes(mesh);
  const Groups faces = lines_as_boundaries(mesh_groups(mesh));
  Exported exported;
  exported.is_binary = true;
  exported.add_loss(periodic_loss(mesh));
  const PlainNames words = add_plain_names(faces, true, exodus_names, exported);
  ExodusModel model{"hexahedra of order " + std::to_string(mesh.order), {{}, {}, {}}, {}, {}};
  for (const Vec3 node : mesh.nodes)
    model.x[0].push_back(node.x), model.x[1].push_back(node.y), model.x[2].push_back(node.z);
  const std::vector<std::int32_t> numbers = add_blocks(
      words.regions, mesh.order == 1 ? "HEX8" : "HEX27", mesh.num_elems(),
      [&](int elem) { return faces.block2region[mesh.quad_block[elem % mesh.num_quads]]; },
      [&](int elem) { return exodus_hex(mesh, elem); }, model);
  model.side_sets = named_sets(words.boundaries);
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g)
    for (const GroupFace at : faces_once(mesh.face_groups[g], numbering)) {
      ExodusSideSet& set = model.side_sets[faces.curve2boundary[g]];
      set.elems.push_back(numbers[at.elem]), set.sides.push_back(at.face + 1);
    }
  exported.bytes = exodus_file(std::move(model));
  return exported;
}

}  // namespace quadrille::exports
