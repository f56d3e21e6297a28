#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "export/edge_numbering.hpp"
#include "export/groups.hpp"
#include "export/nek_bytes.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

class Re2Writer : NekRe2Bytes {
 public:
  Re2Writer(const QuadMesh& mesh, const Frame& frame, const Groups& groups)
      : mesh_(mesh), frame_(frame), groups_(groups), edges_(number_edges(mesh)) {
    require_edges_known_by_ends(mesh, edges_, "Nek5000");
  }

  std::string bytes() {
    begin(mesh_.num_elems(), 2);
    write_corners();
    write_curved_sides();
    write_boundaries();
    return std::move(out_);
  }

 private:
  bool has_groups() const { return !mesh_.block_region.empty(); }

  void write_corners() {
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      // Group of material properties: 0 in a face of one region.
      put(has_groups() ? 1 + groups_.block2region[mesh_.elem_block[elem]] : 0);
      for (int axis = 0; axis < 2; ++axis)
        for (int corner = 0; corner < 4; ++corner)
          put(frame_.at(mesh_.nodes[edges_.vertices[edges_.elem2verts[4 * elem + corner]]])[axis]);
    }
  }

  void write_curved_sides() {
    std::vector<bool> is_curved;
    std::vector<std::array<double, 3>> middles;
    const Eigen::MatrixXd to_middle = spectral::interpolation_matrix(spectral::gll_points(mesh_.order), {0.0});
    for (const NumberedEdge& edge : edges_.edges) {
      const std::vector<int> nodes = edge_nodes(mesh_, edge);
      is_curved.push_back(!is_straight_edge(mesh_, nodes));
      Vec2 middle;
      for (int k = 0; k <= mesh_.order; ++k) middle += to_middle(0, k) * mesh_.nodes[nodes[k]];
      middles.push_back(frame_.at(middle));
    }
    int count = 0;
    for (const int edge : edges_.elem2edges) count += is_curved[edge];
    put(count);
    for (std::size_t k = 0; k < edges_.elem2edges.size(); ++k)
      if (const int edge = edges_.elem2edges[k]; is_curved[edge])
        write_record(static_cast<int>(k / 4), static_cast<int>(k % 4), {middles[edge][0], middles[edge][1], 0, 0, 0},
                     "m");
  }

  void write_boundaries() {
    std::vector<QuadBoundaryEdge> by_elem = mesh_.boundary_edges;
    std::sort(by_elem.begin(), by_elem.end(), [](const QuadBoundaryEdge& a, const QuadBoundaryEdge& b) {
      return std::tie(a.elem, a.side) < std::tie(b.elem, b.side);
    });
    const std::map<std::pair<int, int>, QuadBoundaryEdge> partners = periodic_partner_edges();
    put(static_cast<double>(by_elem.size()));
    for (const QuadBoundaryEdge& e : by_elem)
      if (const auto partner = partners.find({e.elem, e.side}); partner != partners.end())
        write_record(
            e.elem, e.side,
            {1.0 + partner->second.elem, 1.0 + partner->second.side, 0, 0, 1.0 + groups_.curve2boundary[e.curve]}, "P");
      else
        write_record(e.elem, e.side, {0, 0, 0, 0, 1.0 + groups_.curve2boundary[e.curve]}, "MSH");
  }

  /// By element and side.
  std::map<std::pair<int, int>, QuadBoundaryEdge> periodic_partner_edges() const {
    std::map<std::pair<int, int>, QuadBoundaryEdge> partners;
    for (const PeriodicEdges& edges : periodic_edges(mesh_)) {
      const QuadBoundaryEdge &a = mesh_.boundary_edges[edges.first], &b = mesh_.boundary_edges[edges.second];
      partners[{a.elem, a.side}] = b;
      partners[{b.elem, b.side}] = a;
    }
    return partners;
  }

  const QuadMesh& mesh_;
  const Frame& frame_;
  const Groups& groups_;
  EdgeNumbering edges_;
};

void report_losses(const QuadMesh& mesh, const Groups& groups, Exported& exported) {
  const TransfiniteLoss loss = transfinite_loss(mesh, RebuiltFrom::quadratic_sides, "Nek5000");
  const double diameter = mesh.face.diameter, least = 1e-12 * diameter;
  if (loss.sides > least)
    exported.add_loss(fmt::format(
        "sides are stored as parabolas, which moves them by up to {}; *0.f00000 contains the geometry of order {}",
        length_text(loss.sides, diameter), mesh.order));
  else if (loss.interior > least)
    exported.add_loss(
        fmt::format("nodes inside elements are rebuilt from the sides, which moves them by up to {}; "
                    "*0.f00000 contains the original ones",
                    length_text(loss.interior, diameter)));
  exported.add_loss("names are stored as numbers, which *.names.json lists");
  exported.add_loss(interface_loss(groups));
  if (mesh.block_region.empty()) exported.add_loss(region_loss(groups));
}

std::vector<std::array<double, 3>> node_positions(const QuadMesh& mesh, const Frame& frame) {
  std::vector<std::array<double, 3>> points;
  for (const Vec2 x : mesh.nodes) points.push_back(frame.at(x));
  return points;
}

}  // namespace

Exported nek_re2(const QuadMesh& mesh, const Frame& frame) {
  const Groups groups = mesh_groups(mesh);
  Exported exported;
  report_losses(mesh, groups, exported);
  exported.bytes = Re2Writer(mesh, frame, groups).bytes();
  exported.is_binary = true;
  const std::vector<std::string> regions = mesh.block_region.empty() ? std::vector<std::string>() : groups.region_names;
  exported.side_files.push_back(names_table(groups, groups.boundary_names, regions));
  if (mesh.order > 1)
    exported.side_files.push_back(
        {nek_field_name, nek_geometry_field(mesh.order, 2, mesh.elem_nodes, node_positions(mesh, frame)), true});
  return exported;
}

}  // namespace quadrille::exports
