#include "export/hohqmesh_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "export/edge_numbering.hpp"
#include "export/element_blend.hpp"
#include "export/groups.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/skeleton.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {
namespace {

void number_corners(const EdgeNumbering& numbering, HohqmeshModel& model) {
  model.corners = numbering.vertices;
  for (std::size_t k = 0; k < numbering.elem2verts.size(); k += 4) {
    const int* c = &numbering.elem2verts[k];
    model.elem_corners.push_back({c[0] + 1, c[1] + 1, c[2] + 1, c[3] + 1});
  }
}

void find_edges(const EdgeNumbering& numbering, HohqmeshModel& model) {
  for (const NumberedEdge& e : numbering.edges) model.edges.push_back({e.elem, e.side});
  for (std::size_t k = 0; k < numbering.elem2edges.size(); ++k) {
    HohqmeshEdge& edge = model.edges[numbering.elem2edges[k]];
    const int elem = static_cast<int>(k / 4), side = static_cast<int>(k % 4);
    if (elem != edge.elem || side != edge.side) edge.other_elem = elem, edge.other_side = side;
  }
}

/// A side is curved where it differs from the segment between its ends that a reader draws for a straight one, at the
/// same parameter: a straight side with uneven nodes is.
void mark_curved_sides(const QuadMesh& mesh, HohqmeshModel& model) {
  model.is_curved.resize(mesh.elem_block.size());
  for (const HohqmeshEdge& e : model.edges) {
    const bool is_curved = !is_straight_edge(mesh, side_nodes(mesh, e.elem, e.side));
    model.is_curved[e.elem][e.side] = is_curved;
    if (e.other_elem >= 0) model.is_curved[e.other_elem][e.other_side] = is_curved;
  }
}

void find_boundaries(const QuadMesh& mesh, const Groups& groups, HohqmeshModel& model) {
  model.boundary.assign(mesh.elem_block.size(), {-1, -1, -1, -1});
  for (const QuadBoundaryEdge& e : mesh.boundary_edges) model.boundary[e.elem][e.side] = groups.curve2boundary[e.curve];
}

void name_groups(const QuadMesh& mesh, const Groups& groups, Materials materials, HohqmeshModel& model) {
  const PlainNames plain = add_plain_names(groups, materials == Materials::kept, {}, model);
  model.names = plain.boundaries;
  for (const int block : mesh.elem_block)
    if (!plain.regions.empty()) model.materials.push_back(plain.regions[groups.block2region[block]]);
}

void report_losses(const QuadMesh& mesh, const Groups& groups, Materials materials, HohqmeshModel& model) {
  const TransfiniteLoss loss = transfinite_loss(mesh, RebuiltFrom::sides, "a reader of this format");
  if (loss.interior > 1e-12 * mesh.face.diameter)
    model.add_loss(fmt::format(
        "nodes inside elements are not stored; a reader rebuilds them from the sides, which moves them by up to {}",
        length_text(loss.interior, mesh.face.diameter)));
  model.add_loss(interface_loss(groups));
  if (materials == Materials::lost) model.add_loss(region_loss(groups));
}

}  // namespace

HohqmeshModel hohqmesh_model(const QuadMesh& mesh, const Frame& frame, Materials materials) {
  HohqmeshModel model;
  const Groups groups = mesh_groups(mesh);
  const EdgeNumbering numbering = number_edges(mesh);
  number_corners(numbering, model);
  find_edges(numbering, model);
  mark_curved_sides(mesh, model);
  find_boundaries(mesh, groups, model);
  const Eigen::MatrixXd to_chebyshev =
      spectral::interpolation_matrix(spectral::gll_points(mesh.order), chebyshev_lobatto_points(mesh.order));
  for (const Vec2 x : renoded(mesh, to_chebyshev)) model.points.push_back(frame.at(x));
  name_groups(mesh, groups, materials, model);
  report_losses(mesh, groups, materials, model);
  return model;
}

const std::string& HohqmeshModel::name(int elem, int side) const {
  static const std::string inside = "---";
  const int group = boundary[elem][side];
  return group < 0 ? inside : names[group];
}

void join_periodic_edges(const QuadMesh& mesh, HohqmeshModel& model) {
  std::map<std::pair<int, int>, int> edge_of;  // by element and side of boundary edges
  for (std::size_t e = 0; e < model.edges.size(); ++e)
    if (model.edges[e].other_elem < 0) edge_of[{model.edges[e].elem, model.edges[e].side}] = static_cast<int>(e);
  std::vector<bool> is_joined(model.edges.size(), false);
  for (const PeriodicEdges& pair : periodic_edges(mesh)) {
    if (mesh.face.periodic_pairs[pair.pair].angle != 0) continue;
    const QuadBoundaryEdge &first = mesh.boundary_edges[pair.first], &second = mesh.boundary_edges[pair.second];
    const auto [lower, higher] =
        std::minmax(edge_of.at({first.elem, first.side}), edge_of.at({second.elem, second.side}));
    HohqmeshEdge &kept = model.edges[lower], &other = model.edges[higher];
    kept.other_elem = other.elem, kept.other_side = other.side;
    is_joined[higher] = true;
    model.boundary[kept.elem][kept.side] = model.boundary[other.elem][other.side] = -1;
  }
  std::size_t number = 0;
  std::erase_if(model.edges, [&](const HohqmeshEdge&) { return is_joined[number++]; });
}

std::string rotation_loss(const CadFace& face) {
  return periodic_loss(face, rotated_pairs(face), "the solvers couple sides that are moved, not turned");
}

std::vector<int> hohqmesh_side(const QuadMesh& mesh, int elem, int side) {
  std::vector<int> nodes = side_nodes(mesh, elem, side);
  if (side >= 2) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace quadrille::exports
