#include <array>
#include <utility>
#include <vector>

#include "export/cgns_request.hpp"
#include "export/cgns_words.hpp"
#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// The edges bottom, upright, top, each in the standard's direction.
constexpr std::array<std::array<int, 2>, 12> cgns_hex_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5}, {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}}};

/// The faces by the corners where the rings of their inner nodes begin: bottom, sides, top.
constexpr std::array<std::array<int, 4>, 6> cgns_hex_faces{
    {{0, 1, 2, 3}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};

/// The nodes of a hexahedron: corners, edges, the insides of faces, then layers from the bottom to the top; faces and
/// layers as quads have their inner nodes, in rings.
std::vector<int> cgns_hex_order(int order) {
  std::vector<int> nodes;
  for (int corner = 0; corner < 8; ++corner) nodes.push_back(hex_corner_node(order, corner));
  for (const auto& [from, to] : cgns_hex_edges) {
    const int start = hex_corner_node(order, from), step = (hex_corner_node(order, to) - start) / order;
    for (int k = 1; k < order; ++k) nodes.push_back(start + k * step);
  }
  std::vector<int> inside = cgns_quad_order(order);
  inside.erase(inside.begin(), inside.begin() + 4 * order);
  for (const std::array<int, 4>& corners : cgns_hex_faces) {
    const std::vector<int> face = local_face_nodes(order, corners);
    for (const int local : inside) nodes.push_back(face[local]);
  }
  for (int layer = 1; layer < order; ++layer)
    for (const int local : inside) nodes.push_back(layer * (order + 1) * (order + 1) + local);
  return nodes;
}

class HexZone {
 public:
  /// `faces`: with interfaces as further boundaries.
  HexZone(const HexMesh& mesh, const Groups& faces, const PlainNames& words)
      : mesh_(mesh), faces_(faces), words_(words), numbering_(number_hexes(mesh)) {}

  CgnsZone zone(int num_boundaries) {
    zone_.name = "zone";
    zone_.size = {static_cast<std::int64_t>(mesh_.nodes.size()), mesh_.num_elems()};
    zone_.x.resize(3);
    for (const std::array<double, 3>& x : positions(mesh_, ElementPoints::equispaced))
      for (int c = 0; c < 3; ++c) zone_.x[c].push_back(x[c]);
    for (int region = 0; region < faces_.num_regions(); ++region) add_hexes(region);
    for (int name = 0; name < faces_.num_boundaries(); ++name) add_faces(name, num_boundaries);
    return std::move(zone_);
  }

 private:
  void add_hexes(int region) {
    CgnsSection section = sections_.begin(words_.regions[region], cgns_hex_types[mesh_.order]);
    const std::vector<int> order = cgns_hex_order(mesh_.order);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      if (faces_.block2region[mesh_.quad_block[elem % mesh_.num_quads]] != region) continue;
      const std::size_t first = static_cast<std::size_t>(elem) * mesh_.nodes_per_elem();
      for (const int local : order) section.nodes.push_back(mesh_.elem_nodes[first + local] + 1);
      ++section.count;
    }
    sections_.add(std::move(section), false, zone_);
  }

  void add_faces(int name, int num_boundaries) {
    CgnsSection section = sections_.begin(words_.boundaries[name], cgns_quad_types[mesh_.order]);
    const std::vector<int> order = cgns_quad_order(mesh_.order);
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g) {
      if (faces_.curve2boundary[g] != name) continue;
      for (const GroupFace at : faces_once(mesh_.face_groups[g], numbering_)) {
        const std::vector<int> nodes = face_nodes(mesh_, at.elem, at.face);
        for (const int local : order) section.nodes.push_back(nodes[local] + 1);
        ++section.count;
      }
    }
    sections_.add(std::move(section), name < num_boundaries, zone_);
  }

  const HexMesh& mesh_;
  const Groups& faces_;
  const PlainNames& words_;
  HexNumbering numbering_;
  CgnsZone zone_;
  CgnsSections sections_;
};

}  // namespace

Exported cgns_unstructured(const HexMesh& mesh) {
  const Groups groups = mesh_groups(mesh), faces = lines_as_boundaries(groups);
  Exported exported;
  exported.is_binary = true;
  exported.add_loss(periodic_loss(mesh));
  const PlainNames words = family_names(faces, exported);
  exported.bytes = to_bytes({false,
                             3,
                             families(faces, words, groups.num_boundaries()),
                             {HexZone(mesh, faces, words).zone(groups.num_boundaries())}});
  return exported;
}

}  // namespace quadrille::exports
