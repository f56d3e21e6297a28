#include <array>

#include "export/groups.hpp"
#include "export/renode.hpp"
#include "export/skeleton.hpp"
#include "export/vtk_xml.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

std::vector<VtkArray<std::string>> texts_of(const QuadMesh& mesh, const Groups& groups) {
  std::vector<std::string> line_names = boundary_and_interface_names(groups);
  return {{"format", {"quad-mesh"}},
          {"provenance", provenance_lines(mesh.provenance)},
          {"length_unit", {mesh.face.length_unit}},
          {"block_names", mesh.block_names},
          {"region_names", groups.region_names},
          {"boundary_names", line_names}};
}

class VtuWriter {
 public:
  VtuWriter(const QuadMesh& mesh, const Frame& frame, ElementPoints points, VtkCellTypes cell_types)
      : mesh_(mesh), groups_(mesh_groups(mesh)), types_(cell_types), positions_(positions(mesh, frame, points)) {}

  VtkGrid quads() const {
    VtkGrid grid;
    grid.points = positions_;
    grid.cell_type = types_.quad;
    grid.nodes_per_cell = mesh_.nodes_per_elem();
    grid.connectivity.reserve(mesh_.elem_nodes.size());
    const std::vector<int> node_order = vtk_quad_order(mesh_.order);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (const int local : node_order)
        grid.connectivity.push_back(mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + local]);
    VtkArray<int> ids{"element_id", {}}, regions{"region_id", {}}, attributes{"attribute", {}};
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
    VtkArray<int> curve_ids{"curve_id", {}}, names{"name_id", {}}, insides{"is_interface", {}};
    VtkArray<int> lefts{"left_block", {}}, rights{"right_block", {}};
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
  VtkCellTypes types_;
  std::vector<std::array<double, 3>> positions_;
};

Exported vtu_files(const VtuWriter& writer) {
  return {vtk_xml(writer.quads()), false, {{vtu_curves_name, vtk_xml(writer.curves())}}, {}};
}

}  // namespace

Exported vtu_lagrange(const QuadMesh& mesh, const Frame& frame) {
  return vtu_files(VtuWriter(mesh, frame, ElementPoints::equispaced, lagrange_cells));
}

Exported vtu_bezier(const QuadMesh& mesh, const Frame& frame) {
  return vtu_files(VtuWriter(mesh, frame, ElementPoints::bezier, bezier_cells));
}

}  // namespace quadrille::exports
