#include "export/abaqus_inp.hpp"

#include <fmt/format.h>

#include <iterator>

#include "export/edge_numbering.hpp"
#include "export/hohqmesh_model.hpp"

namespace quadrille::exports {
namespace {

/// Trixi.jl compares the second line, its leading blank included, and finds the order as the sixth word of its line.
constexpr const char* heading = "*Heading\n File created by HOHQMesh\n";
constexpr const char* second_part = "** ***** HOHQMesh boundary information ***** **\n** mesh polynomial degree = {}\n";

class Writer {
 public:
  Writer(const QuadMesh& mesh, const HohqmeshModel& model) : mesh_(mesh), model_(model) {}

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
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      const std::array<int, 4>& c = model_.elem_corners[elem];
      print("{}, {}, {}, {}, {}\n", elem + 1, c[0], c[1], c[2], c[3]);
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
  fmt::memory_buffer out_;
};

}  // namespace

Exported abaqus_inp(const QuadMesh& mesh, const Frame& frame) {
  require_edges_known_by_ends(mesh, number_edges(mesh), "p4est");
  HohqmeshModel model = hohqmesh_model(mesh, frame);
  std::string text = Writer(mesh, model).text();
  return {std::move(text), false, std::move(model.side_files), std::move(model.losses)};
}

}  // namespace quadrille::exports
