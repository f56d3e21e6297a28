#include "export/gmsh_model.hpp"

#include <map>
#include <set>
#include <utility>

#include "export/cells.hpp"
#include "export/hex_periodic.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/skeleton.hpp"

namespace quadrille::exports {

namespace {

/// Gmsh's types of lines, quads and hexahedra by their order.
constexpr std::array<int, 11> line_types{0, 1, 8, 26, 27, 28, 62, 63, 64, 65, 66};
constexpr std::array<int, 11> quad_types{0, 3, 10, 36, 37, 38, 47, 48, 49, 50, 51};
constexpr std::array<int, 10> hex_types{0, 5, 12, 92, 93, 94, 95, 96, 97, 98};

/// Of a quad of any order from 0, xi1 fastest: corners, then sides counter-clockwise, then the same recursively for the
/// inner nodes.
std::vector<int> gmsh_quad_order(int order) {
  std::vector<int> node_order;
  const auto add = [&](int i, int j) { node_order.push_back(j * (order + 1) + i); };
  for (int low = 0, high = order; low <= high; ++low, --high) {
    if (low == high) {
      add(low, low);
      break;
    }
    add(low, low), add(high, low), add(high, high), add(low, high);
    for (int k = low + 1; k < high; ++k) add(k, low);
    for (int k = low + 1; k < high; ++k) add(high, k);
    for (int k = high - 1; k > low; --k) add(k, high);
    for (int k = high - 1; k > low; --k) add(low, k);
  }
  return node_order;
}

// Gmsh's edges, and its faces by their corners: those of the local quad (0, 0), (N, 0), (N, N), (0, N).
constexpr std::array<std::array<int, 2>, 12> gmsh_edges{
    {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}}};
constexpr std::array<std::array<int, 4>, 6> gmsh_faces{
    {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}};

/// Gmsh's order of the local nodes of a hexahedron: corners, edges, faces (each as a quad), then the same recursively
/// for the inner nodes.
class HexOrder {
 public:
  explicit HexOrder(int order) : order_(order) {
    for (low_ = 0, high_ = order; low_ < high_; ++low_, --high_) add_shell();
    if (low_ == high_) node_order_.push_back(low_ * (1 + (order + 1) * (order + 2)));
  }
  std::vector<int> take() { return std::move(node_order_); }

 private:
  int stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? order_ + 1 : (order_ + 1) * (order_ + 1); }

  int corner(int c) const {
    int node = 0;
    for (int axis = 0; axis < 3; ++axis) node += stride(axis) * (hex_corner_indices[c][axis] == 0 ? low_ : high_);
    return node;
  }

  int step(int from, int to) const { return (corner(to) - corner(from)) / (high_ - low_); }

  void add_shell() {
    for (int c = 0; c < 8; ++c) node_order_.push_back(corner(c));
    for (const auto& [from, to] : gmsh_edges)
      for (int k = 1; k < high_ - low_; ++k) node_order_.push_back(corner(from) + k * step(from, to));
    const int inner = high_ - low_ - 1;  // nodes of a face inside, in each direction
    for (const auto& c : gmsh_faces) {
      const int along = step(c[0], c[1]), across = step(c[0], c[3]);
      for (const int local : gmsh_quad_order(inner - 1))
        node_order_.push_back(corner(c[0]) + (1 + local % inner) * along + (1 + local / inner) * across);
    }
  }

  int order_, low_ = 0, high_ = 0;
  std::vector<int> node_order_;
};

void append(const std::vector<int>& nodes, std::vector<int>& list) {
  list.insert(list.end(), nodes.begin(), nodes.end());
}

template <typename Mesh>
void append_element(const Mesh& mesh, int elem, GmshEntity& entity) {
  const int* const nodes = element_nodes(mesh, elem);
  entity.elem_nodes.insert(entity.elem_nodes.end(), nodes, nodes + mesh.nodes_per_elem());
}

/// The tag of the first group of elements.
int first_region(const Groups& groups) { return 1 + groups.num_boundaries() + groups.num_interfaces(); }

/// Fills own_nodes and node_tags.
void number_nodes(GmshModel& model) {
  model.node_tags.assign(model.positions.size(), 0);
  int tag = 0;
  for (auto& entities : model.entities)
    for (GmshEntity& entity : entities)
      for (const int node : entity.elem_nodes)
        if (model.node_tags[node] == 0) entity.own_nodes.push_back(node), model.node_tags[node] = ++tag;
}

// The links of curves by the side of an element.
using SideTable = std::map<std::pair<int, int>, int>;

SideTable curves_by_side(const Skeleton& skeleton) {
  SideTable table;
  for (std::size_t c = 0; c < skeleton.curves.size(); ++c)
    if (skeleton.curves[c].is_boundary())
      for (const SkeletonEdge& e : skeleton.curves[c].edges) table[{e.elem, e.side}] = static_cast<int>(c);
  return table;
}

/// A point that is the image of several has one link.
std::vector<GmshPeriodicLink> periodic_links(const Skeleton& skeleton, const QuadMesh& mesh, const Frame& frame) {
  const SideTable curves = curves_by_side(skeleton);
  std::map<int, GmshPeriodicLink> points, links;  // by the entity
  std::map<int, int> point_of_node;
  for (std::size_t p = 0; p < skeleton.points.size(); ++p) point_of_node[skeleton.points[p]] = static_cast<int>(p);
  std::set<std::pair<int, int>> known;  // the curve and the node
  for (const PeriodicEdges& edges : periodic_edges(mesh)) {
    const QuadBoundaryEdge &first = mesh.boundary_edges[edges.first], &second = mesh.boundary_edges[edges.second];
    const int master = curves.at({first.elem, first.side}), curve = curves.at({second.elem, second.side});
    GmshPeriodicLink& link =
        links.try_emplace(curve, GmshPeriodicLink{1, curve, master, affine_motion(mesh.face, edges.pair, frame), {}})
            .first->second;
    const std::vector<int> from = side_nodes(mesh, first.elem, first.side);
    const std::vector<int> to = side_nodes(mesh, second.elem, second.side);
    for (int k = 0; k <= mesh.order; ++k) {
      const int node = to[k], of = from[mesh.order - k];
      if (known.insert({curve, node}).second) link.nodes.push_back({node, of});
      const auto point = point_of_node.find(node), origin = point_of_node.find(of);
      if (point == point_of_node.end() || origin == point_of_node.end() || node == of) continue;
      points.try_emplace(point->second, GmshPeriodicLink{0, point->second, origin->second, link.motion, {{node, of}}});
    }
  }
  std::vector<GmshPeriodicLink> all;
  for (const auto* of : {&points, &links})
    for (const auto& [entity, link] : *of) all.push_back(link);
  return all;
}

/// One for each group that has an image.
std::vector<GmshPeriodicLink> periodic_links(const HexMesh& mesh) {
  std::vector<GmshPeriodicLink> all;
  std::vector<bool> is_known;  // of the nodes of the last link
  int group = -1;
  for (const PeriodicFaces& faces : periodic_faces(mesh)) {
    if (faces.group != group) {
      group = faces.group;
      const HexFaceGroup& first = mesh.face_groups[group];
      all.push_back({2, first.periodic_with, group, affine_motion(first.motion), {}});
      is_known.assign(mesh.nodes.size(), false);
    }
    for (const auto& [node, image] : faces.nodes) {
      if (!is_known[image]) all.back().nodes.push_back({image, node});
      is_known[image] = true;
    }
  }
  return all;
}

}  // namespace

GmshModel gmsh_model(const QuadMesh& mesh, const Frame& frame) {
  const Skeleton skeleton = mesh_skeleton(mesh);
  GmshModel model;
  model.groups = mesh_groups(mesh);
  model.positions = positions(mesh, frame, ElementPoints::equispaced);
  model.types = {0, line_types[mesh.order], quad_types[mesh.order], 0};
  model.node_orders = {{{}, ends_first(mesh.order), gmsh_quad_order(mesh.order), {}}};
  auto& [points, curves, surfaces, volumes] = model.entities;
  for (const int node : skeleton.points) points.push_back({0, {}, {node}});
  for (const int region : model.groups.block2region) surfaces.push_back({first_region(model.groups) + region});
  for (const SkeletonCurve& curve : skeleton.curves) {
    curves.push_back({curve.cad_curve < 0 ? 0 : 1 + model.groups.curve2boundary[curve.cad_curve],
                      {curve.from + 1, -(curve.to + 1)},
                      {},
                      {},
                      !curve.is_boundary()});
    for (const SkeletonEdge& e : curve.edges) append(side_nodes(mesh, e.elem, e.side), curves.back().elem_nodes);
    const int tag = static_cast<int>(curves.size());
    surfaces[curve.blocks[0]].bounds.push_back(tag);
    if (!curve.is_boundary()) surfaces[curve.blocks[1]].bounds.push_back(-tag);
  }
  for (int elem = 0; elem < mesh.num_elems(); ++elem) append_element(mesh, elem, surfaces[mesh.elem_block[elem]]);
  number_nodes(model);
  model.links = periodic_links(skeleton, mesh, frame);
  return model;
}

GmshModel gmsh_model(const HexMesh& mesh) {
  GmshModel model;
  model.dimension = 3;
  model.groups = mesh_groups(mesh);
  model.positions = positions(mesh, ElementPoints::equispaced);
  model.types = {0, 0, quad_types[mesh.order], hex_types[mesh.order]};
  model.node_orders = {{{}, {}, gmsh_quad_order(mesh.order), HexOrder(mesh.order).take()}};
  const HexNumbering numbering = number_parts(mesh);
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g) {
    GmshEntity& surface = model.entities[2].emplace_back(GmshEntity{1 + model.groups.curve2boundary[g]});
    for (const GroupFace at : faces_once(mesh.face_groups[g], numbering))
      append(face_nodes(mesh, at.elem, at.face), surface.elem_nodes);
  }
  for (const std::vector<int>& elems : elements_by_region(mesh, model.groups)) {
    GmshEntity& volume = model.entities[3].emplace_back();
    volume.group = first_region(model.groups) + static_cast<int>(model.entities[3].size()) - 1;
    for (const int elem : elems) append_element(mesh, elem, volume);
  }
  number_nodes(model);
  model.links = periodic_links(mesh);
  return model;
}

}  // namespace quadrille::exports
