#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/renode.hpp"
#include "export/vtk_xml.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

/// VTK's order of the local nodes of a hexahedron since its file version 2.2: corners, edges as in hex_edge_corners,
/// the faces -x, +x, -y, +y, -z, +z and the inner ones with the first coordinate fastest.
std::vector<int> vtk_hex_order(int order) {
  const int n = order;
  std::vector<int> node_order;
  const auto add = [&](int i, int j, int k) { node_order.push_back((k * (n + 1) + j) * (n + 1) + i); };
  for (int c = 0; c < 8; ++c) node_order.push_back(hex_corner_node(n, c));
  for (const auto& [from, to] : hex_edge_corners)
    for (int k = 1; k < n; ++k)
      node_order.push_back(hex_corner_node(n, from) + k * (hex_corner_node(n, to) - hex_corner_node(n, from)) / n);
  const auto for_inner = [&](const auto& act) {
    for (int b = 1; b < n; ++b)
      for (int a = 1; a < n; ++a) act(a, b);
  };
  for (const int i : {0, n}) for_inner([&](int j, int k) { add(i, j, k); });
  for (const int j : {0, n}) for_inner([&](int i, int k) { add(i, j, k); });
  for (const int k : {0, n}) for_inner([&](int i, int j) { add(i, j, k); });
  for (int k = 1; k < n; ++k) for_inner([&](int i, int j) { add(i, j, k); });
  return node_order;
}

std::vector<VtkArray<std::string>> texts_of(const HexMesh& mesh, const Groups& groups) {
  return {{"format", {"hex-mesh"}},
          {"provenance", provenance_lines(mesh.provenance)},
          {"length_unit", {mesh.length_unit}},
          {"region_names", groups.region_names},
          {"boundary_names", boundary_and_interface_names(groups)}};
}

class VtuHexWriter {
 public:
  VtuHexWriter(const HexMesh& mesh, ElementPoints points, VtkCellTypes cell_types)
      : mesh_(mesh), groups_(mesh_groups(mesh)), types_(cell_types), positions_(positions(mesh, points)) {}

  VtkGrid hexes() const {
    VtkGrid grid = empty_grid(types_.hex, mesh_.nodes_per_elem());
    grid.points = positions_;
    const std::vector<int> node_order = vtk_hex_order(mesh_.order);
    VtkArray<int> blocks{"block_id", {}}, regions{"region_id", {}}, layers{"layer_id", {}}, ids{"element_id", {}},
        attributes{"attribute", {}};
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      const std::size_t first = static_cast<std::size_t>(elem) * mesh_.nodes_per_elem();
      for (const int local : node_order) grid.connectivity.push_back(mesh_.elem_nodes[first + local]);
      blocks.values.push_back(mesh_.quad_block[elem % mesh_.num_quads]);
      regions.values.push_back(groups_.block2region[blocks.values.back()]);
      layers.values.push_back(elem / mesh_.num_quads);
      ids.values.push_back(elem);
      attributes.values.push_back(regions.values.back() + 1);
    }
    grid.cell_integers = {blocks, regions, layers, ids, attributes};
    grid.cell_reals = {{"least_scaled_jacobian", mesh_.elem_scaled_jacobian},
                       {"least_jacobian_bound", mesh_.elem_jacobian_bound}};
    return grid;
  }

  /// Points are numbered in the order of their first use.
  VtkGrid faces() const {
    VtkGrid grid = empty_grid(types_.quad, (mesh_.order + 1) * (mesh_.order + 1));
    const std::vector<int> node_order = vtk_quad_order(mesh_.order);
    const HexNumbering numbering = number_hexes(mesh_);
    VtkArray<int> names{"name_id", {}}, insides{"is_interface", {}}, elems{"element_id", {}};
    std::vector<int> point_of(positions_.size(), -1);
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g)
      for (const GroupFace at : faces_once(mesh_.face_groups[g], numbering)) {
        const std::vector<int> nodes = face_nodes(mesh_, at.elem, at.face);
        for (const int local : node_order) add_point(nodes[local], point_of, grid);
        names.values.push_back(groups_.curve2boundary[g]);
        insides.values.push_back(mesh_.face_groups[g].is_interface);
        elems.values.push_back(at.elem);
      }
    grid.cell_integers = {names, insides, elems};
    return grid;
  }

 private:
  VtkGrid empty_grid(std::uint8_t type, int nodes_per_cell) const {
    VtkGrid grid;
    grid.cell_type = type;
    grid.nodes_per_cell = nodes_per_cell;
    grid.texts = texts_of(mesh_, groups_);
    grid.version = "2.2";
    return grid;
  }

  void add_point(int node, std::vector<int>& point_of, VtkGrid& grid) const {
    if (point_of[node] < 0) {
      point_of[node] = static_cast<int>(grid.points.size());
      grid.points.push_back(positions_[node]);
    }
    grid.connectivity.push_back(point_of[node]);
  }

  const HexMesh& mesh_;
  Groups groups_;
  VtkCellTypes types_;
  std::vector<std::array<double, 3>> positions_;
};

Exported vtu_files(const HexMesh& mesh, ElementPoints points, VtkCellTypes cell_types) {
  const VtuHexWriter writer(mesh, points, cell_types);
  Exported exported{vtk_xml(writer.hexes()), false, {{vtu_faces_name, vtk_xml(writer.faces())}}, {}};
  exported.add_loss(periodic_loss(mesh));
  return exported;
}

}  // namespace

Exported vtu_lagrange(const HexMesh& mesh) { return vtu_files(mesh, ElementPoints::equispaced, lagrange_cells); }

Exported vtu_bezier(const HexMesh& mesh) { return vtu_files(mesh, ElementPoints::bezier, bezier_cells); }

}  // namespace quadrille::exports
