#include <array>
#include <cstdint>
#include <numeric>
#include <string>

#include "export/exodus_model.hpp"
#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/serendipity.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// Elements of order 2 with all nodes, or with those on edges alone.
enum class ExodusNodes { all, on_edges };

/// By mesh node, from 1; 0: it is not written.
template <typename Mesh>
std::vector<int> node_numbers(const Mesh& mesh, ExodusNodes nodes) {
  if (nodes == ExodusNodes::on_edges) return serendipity_numbers(mesh);
  std::vector<int> numbers(mesh.nodes.size());
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

/// Elements by region, numbered block by block from 1: `block_of` and `nodes_of` of an element, whose type is `shape`
/// and the number of its nodes.
template <typename BlockOf, typename NodesOf>
std::vector<std::int32_t> add_blocks(const NameList& names, const char* shape, int num_elems, const BlockOf& block_of,
                                     const NodesOf& nodes_of, const std::vector<int>& node2number, ExodusModel& model) {
  std::vector<std::int32_t> numbers(num_elems);
  std::int32_t next = 0;
  for (std::size_t b = 0; b < names.size(); ++b) {
    ExodusBlock block{names[b], {}, 0, {}};
    for (int elem = 0; elem < num_elems; ++elem) {
      if (block_of(elem) != static_cast<int>(b)) continue;
      block.nodes_per_elem = 0;
      for (const int node : nodes_of(elem))
        if (node2number[node] > 0) block.nodes.push_back(node2number[node]), ++block.nodes_per_elem;
      numbers[elem] = ++next;
    }
    block.type = shape + std::to_string(block.nodes_per_elem);
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

Exported exodus_of(const QuadMesh& mesh, const Frame& frame, ExodusNodes nodes) {
  const QuadMesh quads = split_to_quadratic(mesh);
  require_valid_pieces(quads, "Elements of Exodus");
  const Groups lines = lines_as_boundaries(mesh_groups(mesh));
  Exported exported;
  exported.is_binary = true;
  exported.add_loss(split_loss(mesh, quads));
  if (nodes == ExodusNodes::on_edges) exported.add_loss(serendipity_loss(quads, "Exodus"));
  const PlainNames words = add_plain_names(lines, true, exodus_names, exported);
  ExodusModel model{"quadrilaterals of order " + std::to_string(quads.order), {{}, {}}, {}, {}};
  const std::vector<int> node2number = node_numbers(quads, nodes);
  for (std::size_t node = 0; node < quads.nodes.size(); ++node)
    for (int c = 0; c < 2 && node2number[node] > 0; ++c) model.x[c].push_back(frame.at(quads.nodes[node])[c]);
  const std::vector<std::int32_t> numbers = add_blocks(
      words.regions, "QUAD", quads.num_elems(), [&](int elem) { return lines.block2region[quads.elem_block[elem]]; },
      [&](int elem) { return exodus_quad(quads, elem); }, node2number, model);
  model.side_sets = named_sets(words.boundaries);
  const std::vector<QuadBoundaryEdge> inner = interface_edges_once(quads);
  for (const auto* edges : {&quads.boundary_edges, &inner})
    for (const QuadBoundaryEdge& e : *edges) {
      ExodusSideSet& set = model.side_sets[lines.curve2boundary[e.curve]];
      set.elems.push_back(numbers[e.elem]), set.sides.push_back(e.side + 1);
    }
  exported.bytes = to_bytes(exodus_request(std::move(model)));
  return exported;
}

/// Faces have the numbers of HexMesh: the sides of the quad, bottom, top.
Exported exodus_of(const HexMesh& mesh, ExodusNodes nodes) {
  const HexNumbering numbering = number_hexes(mesh);
  const Groups faces = lines_as_boundaries(mesh_groups(mesh));
  Exported exported;
  exported.is_binary = true;
  if (nodes == ExodusNodes::on_edges) exported.add_loss(serendipity_loss(mesh, "Exodus"));
  exported.add_loss(periodic_loss(mesh));
  const PlainNames words = add_plain_names(faces, true, exodus_names, exported);
  ExodusModel model{"hexahedra of order " + std::to_string(mesh.order), {{}, {}, {}}, {}, {}};
  const std::vector<int> node2number = node_numbers(mesh, nodes);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    const Vec3 x = mesh.nodes[node];
    if (node2number[node] > 0) model.x[0].push_back(x.x), model.x[1].push_back(x.y), model.x[2].push_back(x.z);
  }
  const std::vector<std::int32_t> numbers = add_blocks(
      words.regions, "HEX", mesh.num_elems(),
      [&](int elem) { return faces.block2region[mesh.quad_block[elem % mesh.num_quads]]; },
      [&](int elem) { return exodus_hex(mesh, elem); }, node2number, model);
  model.side_sets = named_sets(words.boundaries);
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g)
    for (const GroupFace at : faces_once(mesh.face_groups[g], numbering)) {
      ExodusSideSet& set = model.side_sets[faces.curve2boundary[g]];
      set.elems.push_back(numbers[at.elem]), set.sides.push_back(at.face + 1);
    }
  exported.bytes = to_bytes(exodus_request(std::move(model)));
  return exported;
}

}  // namespace

Exported exodus(const QuadMesh& mesh, const Frame& frame) { return exodus_of(mesh, frame, ExodusNodes::all); }
Exported exodus(const HexMesh& mesh) { return exodus_of(mesh, ExodusNodes::all); }

Exported exodus_serendipity(const QuadMesh& mesh, const Frame& frame) {
  return exodus_of(mesh, frame, ExodusNodes::on_edges);
}
Exported exodus_serendipity(const HexMesh& mesh) { return exodus_of(mesh, ExodusNodes::on_edges); }

}  // namespace quadrille::exports
