#include "export/abaqus_inp.hpp"

#include <fmt/format.h>

#include <iterator>

#include "export/edge_numbering.hpp"
#include "export/hohqmesh_model.hpp"
#include "export/periodic_edges.hpp"
#include "export/periodic_vertices.hpp"

namespace quadrille::exports {
namespace {

/// Trixi.jl compares the second line, its leading blank included, and finds the order as the sixth word of its line.
constexpr const char* heading = "*Heading\n File created by HOHQMesh\n";
constexpr const char* second_part = "** ***** HOHQMesh boundary information ***** **\n** mesh polynomial degree = {}\n";

class Writer {
 public:
  Writer(const QuadMesh& mesh, const HohqmeshModel& model, const PeriodicVertices& periodic)
      : mesh_(mesh), model_(model), periodic_(periodic) {}

  std::string text() {
    print(heading);
    write_straight_quads();
    print(second_part, mesh_.order);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) write_sides(elem);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) write_names(elem);
    return fmt::to_string(out_);
  }

 private:
  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

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
  fmt::memory_buffer out_;
};

}  // namespace

Exported abaqus_inp(const QuadMesh& mesh, const Frame& frame) {
  const EdgeNumbering numbering = number_edges(mesh);
  require_edges_known_by_ends(mesh, numbering, "p4est");
  HohqmeshModel model = hohqmesh_model(mesh, frame);
  const PeriodicVertices periodic = periodic_vertices(mesh, numbering, Motions::translations, "p4est");
  if (periodic.are_identified()) {
    join_periodic_edges(mesh, model);
    model.losses.push_back(
        "periodic sides have the same corners in *ELEMENT, from which p4est knows that they are one, and their own in "
        "the "
        "comments that Trixi.jl reads: other programs read wrong quads along " +
        periodic_names(mesh.face, translated_pairs(mesh.face)));
  }
  for (const std::string& loss : {periodic.loss, rotation_loss(mesh.face)})
    if (!loss.empty()) model.losses.push_back(loss);
  std::string text = Writer(mesh, model, periodic).text();
  return {std::move(text), false, std::move(model.side_files), std::move(model.losses)};
}

}  // namespace quadrille::exports
