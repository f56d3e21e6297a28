#include "export/hohqmesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "export/edge_numbering.hpp"
#include "export/groups.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/skeleton.hpp"
#include "export/writers.hpp"
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
  for (const NumberedEdge& e : numbering.edges) model.edges.push_back({e.elem, e.edge});
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
  const EdgeNumbering numbering = number_parts(mesh);
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

namespace {

class IsmWriter : TextWriter {
 public:
  IsmWriter(const QuadMesh& mesh, const HohqmeshModel& model) : mesh_(mesh), model_(model) {}

  std::string text() {
    print("{}\n{} {} {} {}\n", has_materials() ? "ISM-MM" : "ISM-V2", model_.corners.size(), model_.edges.size(),
          mesh_.num_elems(), mesh_.order);
    for (const int node : model_.corners) write_point(node);
    if (!has_materials())
      for (const HohqmeshEdge& edge : model_.edges) write_edge(edge);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) write_element(elem);
    return std::move(out_);
  }

 private:
  bool has_materials() const { return !model_.materials.empty(); }

  void write_point(int node) {
    const std::array<double, 3>& x = model_.points[node];
    print("{} {} {}\n", x[0], x[1], x[2]);
  }

  /// Start, end, element on the left, element on the right, their sides; the last one negative where both sides run the
  /// same way round their elements, so that their points are in opposite order.
  void write_edge(const HohqmeshEdge& e) {
    const std::array<int, 4>& corners = model_.elem_corners[e.elem];
    print("{} {} {} ", corners[e.side], corners[(e.side + 1) % 4], e.elem + 1);
    if (e.other_elem < 0) {
      print("0 {} 0\n", e.side + 1);
      return;
    }
    const bool is_opposite = (e.side < 2) == (e.other_side < 2);
    print("{} {} {}\n", e.other_elem + 1, e.side + 1, (is_opposite ? -1 : 1) * (e.other_side + 1));
  }

  void write_element(int elem) {
    const std::array<int, 4>& c = model_.elem_corners[elem];
    const std::array<bool, 4>& curved = model_.is_curved[elem];
    print("{} {} {} {}", c[0], c[1], c[2], c[3]);
    if (has_materials()) print(" {}", model_.materials[elem]);
    print("\n{:d} {:d} {:d} {:d}\n", curved[0], curved[1], curved[2], curved[3]);
    for (int side = 0; side < 4; ++side)
      if (curved[side])
        for (const int node : hohqmesh_side(mesh_, elem, side)) write_point(node);
    print("{} {} {} {}\n", model_.name(elem, 0), model_.name(elem, 1), model_.name(elem, 2), model_.name(elem, 3));
  }

  const QuadMesh& mesh_;
  const HohqmeshModel& model_;
};

class InpWriter : TextWriter {
 public:
  InpWriter(const QuadMesh& mesh, const HohqmeshModel& model, const PeriodicVertices& periodic)
      : mesh_(mesh), model_(model), periodic_(periodic) {}

  std::string text() {
    print(inp_heading);
    write_straight_quads();
    print(inp_second_part, mesh_.order);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) write_sides(elem);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) write_names(elem);
    return std::move(out_);
  }

 private:
  void write_straight_quads() {
    print("*NODE\n");
    for (std::size_t k = 0; k < model_.corners.size(); ++k) {
      const std::array<double, 3>& x = model_.points[model_.corners[k]];
      print("{}, {}, {}, {}\n", k + 1, x[0], x[1], x[2]);
    }
    print("*ELEMENT, type=CPS4, ELSET=Surface1\n");
    const auto number = [this](int corner) { return periodic_(corner - 1) + 1; };
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      const std::array<int, 4>& c = model_.elem_corners[elem];
      print("{}, {}, {}, {}, {}\n", elem + 1, number(c[0]), number(c[1]), number(c[2]), number(c[3]));
    }
  }

  void write_sides(int elem) {
    const std::array<int, 4>& c = model_.elem_corners[elem];
    const std::array<bool, 4>& curved = model_.is_curved[elem];
    print("**  {} {} {} {}\n", c[0], c[1], c[2], c[3]);
    print("**  {:d} {:d} {:d} {:d}\n", curved[0], curved[1], curved[2], curved[3]);
    for (int side = 0; side < 4; ++side)
      if (curved[side])
        for (const int node : hohqmesh_side(mesh_, elem, side)) {
          const std::array<double, 3>& x = model_.points[node];
          print("**  {} {} {}\n", x[0], x[1], x[2]);
        }
  }

  /// In p4est's order of sides: -x +x -y +y.
  void write_names(int elem) {
    print("** {} {} {} {}\n", model_.name(elem, 3), model_.name(elem, 1), model_.name(elem, 0), model_.name(elem, 2));
  }

  const QuadMesh& mesh_;
  const HohqmeshModel& model_;
  const PeriodicVertices& periodic_;
};

}  // namespace

Exported hohqmesh_ism(const QuadMesh& mesh, const Frame& frame) {
  HohqmeshModel model = hohqmesh_model(mesh, frame, Materials::lost);
  join_periodic_edges(mesh, model);
  model.add_loss(rotation_loss(mesh.face));
  model.bytes = IsmWriter(mesh, model).text();
  return Exported(std::move(model));
}

Exported hohqmesh_ism_mm(const QuadMesh& mesh, const Frame& frame) {
  HohqmeshModel model = hohqmesh_model(mesh, frame, Materials::kept);
  model.bytes = IsmWriter(mesh, model).text();
  return Exported(std::move(model));
}

Exported abaqus_inp(const QuadMesh& mesh, const Frame& frame) {
  const EdgeNumbering numbering = number_parts(mesh);
  require_known_by_vertices(mesh, numbering, "p4est");
  HohqmeshModel model = hohqmesh_model(mesh, frame, Materials::lost);
  const PeriodicVertices periodic = periodic_vertices(mesh, numbering, Motions::translations, "p4est");
  if (periodic.are_identified()) {
    join_periodic_edges(mesh, model);
    model.add_loss(
        "periodic sides have the same corners in *ELEMENT, from which p4est knows that they are one, and their own in "
        "the "
        "comments that Trixi.jl reads: other programs read wrong quads along " +
        periodic_names(mesh.face, translated_pairs(mesh.face)));
  }
  model.add_loss(periodic.loss);
  model.add_loss(rotation_loss(mesh.face));
  model.bytes = InpWriter(mesh, model, periodic).text();
  return Exported(std::move(model));
}

}  // namespace quadrille::exports
