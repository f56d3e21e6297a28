#include "export/vtu.hpp"

#include <fmt/format.h>

#include "export/bezier_points.hpp"
#include "export/equispaced.hpp"
#include "export/groups.hpp"
#include "export/skeleton.hpp"
#include "export/vtk_xml.hpp"

namespace quadrille::exports {
namespace {

struct CellTypes {
  std::uint8_t curve, quad;
};
constexpr CellTypes lagrange_cells{68, 70}, bezier_cells{75, 77};

/// VTK's order of the local nodes: corners, the sides bottom, right, top, left all in the direction of rising xi, then
/// the inner ones, xi1 fastest.
std::vector<int> quad_node_order(int order) {
  std::vector<int> node_order;
  const auto add = [&](int i, int j) { node_order.push_back(j * (order + 1) + i); };
  add(0, 0), add(order, 0), add(order, order), add(0, order);
  for (int k = 1; k < order; ++k) add(k, 0);
  for (int k = 1; k < order; ++k) add(order, k);
  for (int k = 1; k < order; ++k) add(k, order);
  for (int k = 1; k < order; ++k) add(0, k);
  for (int j = 1; j < order; ++j)
    for (int i = 1; i < order; ++i) add(i, j);
  return node_order;
}

std::vector<std::string> provenance_lines(const Provenance& chain) {
  std::vector<std::string> lines;
  for (const ProvenanceStep& step : chain)
    lines.push_back(fmt::format("{} {} {}", step.tool, step.version, step.options));
  return lines;
}

std::vector<VtkTexts> texts_of(const QuadMesh& mesh, const Groups& groups) {
  std::vector<std::string> line_names = groups.boundary_names;
  line_names.insert(line_names.end(), groups.interface_names.begin(), groups.interface_names.end());
  return {{"format", {"quad-mesh"}},
          {"provenance", provenance_lines(mesh.provenance)},
          {"length_unit", {mesh.face.length_unit}},
          {"block_names", mesh.block_names},
          {"region_names", groups.region_names},
          {"boundary_names", line_names}};
}

class Writer {
 public:
  Writer(const QuadMesh& mesh, const Frame& frame, const std::vector<Vec2>& nodes, CellTypes types)
      : mesh_(mesh), groups_(mesh_groups(mesh)), types_(types) {
    positions_.reserve(nodes.size());
    for (const Vec2 x : nodes) positions_.push_back(frame.at(x));
  }

  VtkGrid quads() const {
    VtkGrid grid;
    grid.points = positions_;
    grid.cell_type = types_.quad;
    grid.nodes_per_cell = mesh_.nodes_per_elem();
    grid.connectivity.reserve(mesh_.elem_nodes.size());
    const std::vector<int> node_order = quad_node_order(mesh_.order);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (const int local : node_order)
        grid.connectivity.push_back(mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + local]);
    VtkIntegers ids{"element_id", {}}, regions{"region_id", {}}, attributes{"attribute", {}};
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      ids.values.push_back(elem);
      regions.values.push_back(groups_.block2region[mesh_.elem_block[elem]]);
      attributes.values.push_back(regions.values.back() + 1);
    }
    grid.cell_integers = {{"block_id", mesh_.elem_block}, regions, ids, attributes};
    grid.cell_reals = {{"least_scaled_jacobian", mesh_.elem_scaled_jacobian},
                       {"least_jacobian_bound", mesh_.elem_jacobian_bound}};
    grid.texts = texts_of(mesh_, groups_);
    return grid;
  }

  VtkGrid curves() const {
    VtkGrid grid;
    grid.cell_type = types_.curve;
    grid.nodes_per_cell = mesh_.order + 1;
    VtkIntegers curve_ids{"curve_id", {}}, names{"name_id", {}}, insides{"is_interface", {}};
    VtkIntegers lefts{"left_block", {}}, rights{"right_block", {}};
    std::vector<int> point_of(positions_.size(), -1);
    for (const SkeletonCurve& curve : mesh_skeleton(mesh_).curves)
      for (const SkeletonEdge& edge : curve.edges) {
        add_edge(side_nodes(mesh_, edge.elem, edge.side), point_of, grid);
        curve_ids.values.push_back(curve.cad_curve);
        names.values.push_back(curve.cad_curve < 0 ? -1 : groups_.curve2boundary[curve.cad_curve]);
        insides.values.push_back(!curve.is_boundary());
        lefts.values.push_back(curve.blocks[0]);
        rights.values.push_back(curve.blocks[1]);
      }
    grid.cell_integers = {curve_ids, names, insides, lefts, rights};
    grid.texts = texts_of(mesh_, groups_);
    return grid;
  }

 private:
  /// The ends, then the inner nodes; points are numbered in the order of their first use.
  void add_edge(const std::vector<int>& nodes, std::vector<int>& point_of, VtkGrid& grid) const {
    const auto add = [&](int node) {
      if (point_of[node] < 0) {
        point_of[node] = static_cast<int>(grid.points.size());
        grid.points.push_back(positions_[node]);
      }
      grid.connectivity.push_back(point_of[node]);
    };
    add(nodes.front()), add(nodes.back());
    for (int k = 1; k < mesh_.order; ++k) add(nodes[k]);
  }

  const QuadMesh& mesh_;
  Groups groups_;
  CellTypes types_;
  std::vector<std::array<double, 3>> positions_;
};

Exported exported(const Writer& writer) {
  return {vtk_xml(writer.quads()), false, {{vtu_curves_name, vtk_xml(writer.curves())}}, {}};
}

}  // namespace

Exported vtu_lagrange(const QuadMesh& mesh, const Frame& frame) {
  return exported(Writer(mesh, frame, equispaced_nodes(mesh), lagrange_cells));
}

Exported vtu_bezier(const QuadMesh& mesh, const Frame& frame) {
  return exported(Writer(mesh, frame, bezier_points(mesh), bezier_cells));
}

}  // namespace quadrille::exports
