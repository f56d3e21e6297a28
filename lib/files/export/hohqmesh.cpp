#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "export/edge_numbering.hpp"
#include "export/hohqmesh_model.hpp"
#include "export/periodic_edges.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

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

/// Trixi.jl compares the second line, its leading blank included, and finds the order as the sixth word of its line.
constexpr const char* heading = "*Heading\n File created by HOHQMesh\n";
constexpr const char* second_part = "** ***** HOHQMesh boundary information ***** **\n** mesh polynomial degree = {}\n";

class InpWriter : TextWriter {
 public:
  InpWriter(const QuadMesh& mesh, const HohqmeshModel& model, const PeriodicVertices& periodic)
      : mesh_(mesh), model_(model), periodic_(periodic) {}

  std::string text() {
    print(heading);
    write_straight_quads();
    print(second_part, mesh_.order);
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
  const EdgeNumbering numbering = number_edges(mesh);
  require_edges_known_by_ends(mesh, numbering, "p4est");
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
