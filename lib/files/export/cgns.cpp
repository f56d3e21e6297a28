#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "export/cells.hpp"
#include "export/cgns_request.hpp"
#include "export/cgns_words.hpp"
#include "export/hex_periodic.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// Types of elements by their order.
constexpr std::array<const char*, 5> cgns_bar_types{"", "BAR_2", "BAR_3", "BAR_4", "BAR_5"};
constexpr std::array<const char*, 5> cgns_quad_types{"", "QUAD_4", "QUAD_9", "QUAD_16", "QUAD_25"};
constexpr std::array<const char*, 5> cgns_hex_types{"", "HEXA_8", "HEXA_27", "HEXA_64", "HEXA_125"};

/// The edges of a hexahedron bottom, upright, top, each in the standard's direction.
constexpr std::array<std::array<int, 2>, 12> cgns_hex_edges{
    {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5}, {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}}};

/// The faces by the corners where the rings of their inner nodes begin: bottom, sides, top.
constexpr std::array<std::array<int, 4>, 6> cgns_hex_faces{
    {{0, 1, 2, 3}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};

/// The nodes of a quad: corners, then sides counter-clockwise, then the rings inside in the same way, corner first.
std::vector<int> cgns_quad_order(int order) {
  std::vector<int> nodes;
  for (int side = 0; side < 4; ++side) nodes.push_back(local_side_node(order, side, 0));
  for (int side = 0; side < 4; ++side)
    for (int k = 1; k < order; ++k) nodes.push_back(local_side_node(order, side, k));
  for (int low = 1; 2 * low <= order; ++low) {
    const int size = order - 2 * low, shift = low * (order + 2);
    if (size == 0) nodes.push_back(shift);
    for (int side = 0; side < 4 && size > 0; ++side)
      for (int k = 0; k < size; ++k) {
        const int local = local_side_node(size, side, k);
        nodes.push_back(shift + local / (size + 1) * (order + 1) + local % (size + 1));
      }
  }
  return nodes;
}

/// The nodes of a hexahedron: corners, edges, the insides of faces, then layers from the bottom to the top; faces and
/// layers as quads have their inner nodes, in rings.
std::vector<int> cgns_hex_order(int order) {
  std::vector<int> nodes;
  for (int corner = 0; corner < 8; ++corner) nodes.push_back(hex_corner_node(order, corner));
  for (const auto& corners : cgns_hex_edges) {
    const std::vector<int> edge = local_edge_nodes(order, corners);
    nodes.insert(nodes.end(), edge.begin() + 1, edge.end() - 1);
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

/// One unstructured zone.
template <typename Mesh>
class ZoneMaker {
 public:
  /// `groups` with interfaces as further boundaries.
  ZoneMaker(const Mesh& mesh, const Groups& groups, const PlainNames& words)
      : mesh_(mesh), groups_(groups), words_(words) {}

  CgnsZone zone(const std::vector<std::array<double, 3>>& positions, int space_dim) {
    constexpr bool are_quads = mesh_dimension<Mesh> == 2;
    zone_.name = "zone";
    zone_.size = {static_cast<std::int64_t>(positions.size()), mesh_.num_elems()};
    zone_.x.resize(space_dim);
    for (const std::array<double, 3>& x : positions)
      for (int c = 0; c < space_dim; ++c) zone_.x[c].push_back(x[c]);
    const std::vector<std::vector<int>> elems = elements_by_region(mesh_, groups_);
    const std::vector<int> local_nodes = are_quads ? cgns_quad_order(mesh_.order) : cgns_hex_order(mesh_.order);
    for (std::size_t r = 0; r < elems.size(); ++r) {
      begin(words_.regions[r], (are_quads ? cgns_quad_types : cgns_hex_types)[mesh_.order]);
      for (const int elem : elems[r]) add_element(element_nodes(mesh_, elem), local_nodes);
      end();
    }
    std::vector<std::vector<GroupSide>> sides = sides_by_group(mesh_, groups_);
    const std::vector<int> side_order = are_quads ? ends_first(mesh_.order) : cgns_quad_order(mesh_.order);
    for (int b = 0; b < groups_.num_boundaries(); ++b) {
      begin(words_.boundaries[b], (are_quads ? cgns_bar_types : cgns_quad_types)[mesh_.order]);
      const auto inside =
          std::stable_partition(sides[b].begin(), sides[b].end(), [](const GroupSide& at) { return !at.is_interface; });
      for (const GroupSide& at : sides[b]) add_element(side_nodes(mesh_, at.elem, at.side).data(), side_order);
      end(inside - sides[b].begin());
    }
    return std::move(zone_);
  }

 private:
  void begin(const std::string& name, const char* type) { section_ = {name, type, next_, 0, {}}; }

  void add_element(const int* nodes, const std::vector<int>& local_nodes) {
    for (const int local : local_nodes) section_.nodes.push_back(nodes[local] + 1);
    ++section_.count;
  }

  /// Adds the section to the zone, unless it is empty, and its first elements that are on the boundary as one of its
  /// name.
  void end(std::int64_t on_boundary = 0) {
    if (section_.count == 0) return;
    if (on_boundary > 0) zone_.boundaries.push_back({section_.name, section_.name, {next_, next_ + on_boundary - 1}});
    next_ += section_.count;
    zone_.sections.push_back(std::move(section_));
  }

  const Mesh& mesh_;
  const Groups& groups_;
  const PlainNames& words_;
  CgnsZone zone_;
  CgnsSection section_;
  std::int64_t next_ = 1;  ///< number of the next element
};

template <typename Mesh>
Exported unstructured(const Mesh& mesh, const std::vector<std::array<double, 3>>& positions, int space_dim,
                      const std::string& loss) {
  const Groups groups = mesh_groups(mesh), all = lines_as_boundaries(groups);
  Exported exported;
  exported.is_binary = true;
  exported.add_loss(loss);
  const PlainNames words = family_names(all, exported);
  exported.bytes = to_bytes({false,
                             mesh_dimension<Mesh>,
                             families(all, words, groups.num_boundaries()),
                             {ZoneMaker(mesh, all, words).zone(positions, space_dim)}});
  return exported;
}

}  // namespace

Exported cgns_unstructured(const QuadMesh& mesh, const Frame& frame) {
  return unstructured(mesh, positions(mesh, frame, ElementPoints::equispaced), space_dimension(mesh, frame), "");
}

Exported cgns_unstructured(const HexMesh& mesh) {
  return unstructured(mesh, positions(mesh, ElementPoints::equispaced), 3, periodic_loss(mesh));
}

}  // namespace quadrille::exports
