#include <array>
#include <utility>

#include "export/cells.hpp"
#include "export/hex_periodic.hpp"
#include "export/renode.hpp"
#include "export/skeleton.hpp"
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
  for (const auto& corners : hex_edge_corners) {
    const std::vector<int> edge = local_edge_nodes(n, corners);
    node_order.insert(node_order.end(), edge.begin() + 1, edge.end() - 1);
  }
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

std::vector<VtkArray<std::string>> texts_of(const QuadMesh& mesh, const Groups& groups) {
  return {{"format", {"quad-mesh"}},
          {"provenance", provenance_lines(mesh.provenance)},
          {"length_unit", {mesh.face.length_unit}},
          {"block_names", mesh.block_names},
          {"region_names", groups.region_names},
          {"boundary_names", boundary_and_interface_names(groups)}};
}

std::vector<VtkArray<std::string>> texts_of(const HexMesh& mesh, const Groups& groups) {
  return {{"format", {"hex-mesh"}},
          {"provenance", provenance_lines(mesh.provenance)},
          {"length_unit", {mesh.length_unit}},
          {"region_names", groups.region_names},
          {"boundary_names", boundary_and_interface_names(groups)}};
}

template <typename Mesh>
class VtuWriter {
 public:
  VtuWriter(const Mesh& mesh, std::vector<std::array<double, 3>> positions, VtkCellTypes cell_types)
      : mesh_(mesh), groups_(mesh_groups(mesh)), types_(cell_types), positions_(std::move(positions)) {}

  VtkGrid elements() const {
    VtkGrid grid = empty_grid(is_hex ? types_.hex : types_.quad, mesh_.nodes_per_elem());
    grid.points = positions_;
    const std::vector<int> node_order = is_hex ? vtk_hex_order(mesh_.order) : vtk_quad_order(mesh_.order);
    VtkArray<int> blocks{"block_id", {}}, regions{"region_id", {}}, layers{"layer_id", {}}, ids{"element_id", {}},
        attributes{"attribute", {}};
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      for (const int local : node_order) grid.connectivity.push_back(element_nodes(mesh_, elem)[local]);
      blocks.values.push_back(block_of(mesh_, elem));
      regions.values.push_back(groups_.block2region[blocks.values.back()]);
      if constexpr (is_hex) layers.values.push_back(elem / mesh_.num_quads);
      ids.values.push_back(elem);
      attributes.values.push_back(regions.values.back() + 1);
    }
    grid.cell_integers = {blocks, regions, ids, attributes};
    if (is_hex) grid.cell_integers.insert(grid.cell_integers.begin() + 2, layers);
    grid.cell_reals = {{"least_scaled_jacobian", mesh_.elem_scaled_jacobian},
                       {"least_jacobian_bound", mesh_.elem_jacobian_bound}};
    return grid;
  }

  VtkGrid curves() const {
    VtkGrid grid = empty_grid(types_.curve, mesh_.order + 1);
    VtkArray<int> curve_ids{"curve_id", {}}, names{"name_id", {}}, insides{"is_interface", {}};
    VtkArray<int> lefts{"left_block", {}}, rights{"right_block", {}};
    PointNumbers numbers(positions_.size(), -1);
    for (const SkeletonCurve& curve : mesh_skeleton(mesh_).curves)
      for (const SkeletonEdge& edge : curve.edges) {
        add_cell(side_nodes(mesh_, edge.elem, edge.side), ends_first(mesh_.order), numbers, grid);
        curve_ids.values.push_back(curve.cad_curve);
        names.values.push_back(curve.cad_curve < 0 ? -1 : groups_.curve2boundary[curve.cad_curve]);
        insides.values.push_back(!curve.is_boundary());
        lefts.values.push_back(curve.blocks[0]);
        rights.values.push_back(curve.blocks[1]);
      }
    grid.cell_integers = {curve_ids, names, insides, lefts, rights};
    return grid;
  }

  VtkGrid faces() const {
    VtkGrid grid = empty_grid(types_.quad, (mesh_.order + 1) * (mesh_.order + 1));
    VtkArray<int> names{"name_id", {}}, insides{"is_interface", {}}, elems{"element_id", {}};
    PointNumbers numbers(positions_.size(), -1);
    const HexNumbering numbering = number_parts(mesh_);
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g)
      for (const GroupFace at : faces_once(mesh_.face_groups[g], numbering)) {
        add_cell(face_nodes(mesh_, at.elem, at.face), vtk_quad_order(mesh_.order), numbers, grid);
        names.values.push_back(groups_.curve2boundary[g]);
        insides.values.push_back(mesh_.face_groups[g].is_interface);
        elems.values.push_back(at.elem);
      }
    grid.cell_integers = {names, insides, elems};
    return grid;
  }

 private:
  static constexpr bool is_hex = mesh_dimension<Mesh> == 3;
  using PointNumbers = std::vector<int>;  ///< by mesh node; -1: it is no point yet

  VtkGrid empty_grid(std::uint8_t type, int nodes_per_cell) const {
    VtkGrid grid;
    grid.cell_type = type;
    grid.nodes_per_cell = nodes_per_cell;
    grid.texts = texts_of(mesh_, groups_);
    if (is_hex) grid.version = "2.2";
    return grid;
  }

  /// Points are numbered in the order of their first use.
  void add_cell(const std::vector<int>& nodes, const std::vector<int>& node_order, PointNumbers& numbers,
                VtkGrid& grid) const {
    for (const int local : node_order) {
      int& number = numbers[nodes[local]];
      if (number < 0) {
        number = static_cast<int>(grid.points.size());
        grid.points.push_back(positions_[nodes[local]]);
      }
      grid.connectivity.push_back(number);
    }
  }

  const Mesh& mesh_;
  Groups groups_;
  VtkCellTypes types_;
  std::vector<std::array<double, 3>> positions_;
};

Exported vtu_files(const QuadMesh& mesh, const Frame& frame, ElementPoints points, VtkCellTypes cell_types) {
  const VtuWriter writer(mesh, positions(mesh, frame, points), cell_types);
  return {vtk_xml(writer.elements()), false, {{vtu_curves_name, vtk_xml(writer.curves())}}, {}};
}

Exported vtu_files(const HexMesh& mesh, ElementPoints points, VtkCellTypes cell_types) {
  const VtuWriter writer(mesh, positions(mesh, points), cell_types);
  Exported exported{vtk_xml(writer.elements()), false, {{vtu_faces_name, vtk_xml(writer.faces())}}, {}};
  exported.add_loss(periodic_loss(mesh));
  return exported;
}

}  // namespace

Exported vtu_lagrange(const QuadMesh& mesh, const Frame& frame) {
  return vtu_files(mesh, frame, ElementPoints::equispaced, lagrange_cells);
}

Exported vtu_bezier(const QuadMesh& mesh, const Frame& frame) {
  return vtu_files(mesh, frame, ElementPoints::bezier, bezier_cells);
}

Exported vtu_lagrange(const HexMesh& mesh) { return vtu_files(mesh, ElementPoints::equispaced, lagrange_cells); }

Exported vtu_bezier(const HexMesh& mesh) { return vtu_files(mesh, ElementPoints::bezier, bezier_cells); }

}  // namespace quadrille::exports
