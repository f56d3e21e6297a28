#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "export/abaqus_text.hpp"
#include "export/groups.hpp"
#include "export/serendipity.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

class AbaqusWriter : AbaqusText {
 public:
  AbaqusWriter(const QuadMesh& quads, const Frame& frame, const Groups& lines)
      : quads_(quads), frame_(frame), lines_(lines), numbers_(serendipity_numbers(quads)) {}

  std::string text(const char* type, const PlainNames& words) {
    print("*HEADING\nquadrilaterals of order {}\n", quads_.order);
    write_nodes();
    write_elements(fmt::format("{}{}", type, quads_.order == 1 ? 4 : 8), words.regions);
    write_lines(words.boundaries);
    return std::move(out_);
  }

 private:
  void write_nodes() {
    print("*NODE, NSET=NALL\n");
    for (std::size_t node = 0; node < numbers_.size(); ++node) {
      if (numbers_[node] == 0) continue;
      const std::array<double, 3> x = frame_.at(quads_.nodes[node]);
      print_node(numbers_[node], {x[0], x[1], 0});
    }
  }

  /// Corners counter-clockwise, then the middles of the sides after them.
  void write_element(int elem) {
    print("{}", elem + 1);
    for (int k = 0; k < quads_.order; ++k)
      for (int side = 0; side < 4; ++side) print(", {}", numbers_[side_node(quads_, elem, side, k)]);
    print("\n");
  }

  void write_elements(const std::string& type, const NameList& regions) {
    for (std::size_t region = 0; region < regions.size(); ++region) {
      print("*ELEMENT, TYPE={}, ELSET={}\n", type, regions[region]);
      for (int elem = 0; elem < quads_.num_elems(); ++elem)
        if (lines_.block2region[quads_.elem_block[elem]] == static_cast<int>(region)) write_element(elem);
    }
    print_all_elements(regions);
  }

  void write_lines(const NameList& names) {
    std::vector<std::vector<QuadBoundaryEdge>> edges(names.size());
    for (const QuadBoundaryEdge& e : quads_.boundary_edges) edges[lines_.curve2boundary[e.curve]].push_back(e);
    for (const QuadBoundaryEdge& e : interface_edges_once(quads_)) edges[lines_.curve2boundary[e.curve]].push_back(e);
    for (std::size_t line = 0; line < names.size(); ++line) {
      if (edges[line].empty()) continue;
      write_node_set(names[line], edges[line]);
      print("*SURFACE, NAME={}, TYPE=ELEMENT\n", names[line]);
      for (const QuadBoundaryEdge& e : edges[line]) print("{}, S{}\n", e.elem + 1, e.side + 1);
    }
  }

  void write_node_set(const std::string& name, const std::vector<QuadBoundaryEdge>& edges) {
    std::vector<int> nodes;
    for (const QuadBoundaryEdge& e : edges)
      for (int k = 0; k <= quads_.order; ++k) nodes.push_back(numbers_[side_node(quads_, e.elem, e.side, k)]);
    print_node_set(name, std::move(nodes));
  }

  const QuadMesh& quads_;
  const Frame& frame_;
  const Groups& lines_;
  std::vector<int> numbers_;  ///< by mesh node, from 1; 0: it is not written
};

void require_radii(const QuadMesh& quads, const Frame& frame) {
  double least = 0;
  for (const Vec2 x : quads.nodes) least = std::min(least, frame.at(x)[0]);
  if (least < -1e-12 * quads.face.diameter)
    throw ComputeError(
        fmt::format("x is the radius of axisymmetric elements, and the mesh begins at x = {:g}: move the drawing so "
                    "that the axis is x = 0 and the mesh on its right",
                    least));
}

Exported abaqus(const QuadMesh& mesh, const Frame& frame, const char* type) {
  const QuadMesh quads = split_to_quadratic(mesh);
  require_valid_pieces(quads, "Abaqus elements");
  const Groups lines = lines_as_boundaries(mesh_groups(mesh));
  Exported exported;
  exported.add_loss(split_loss(mesh, quads));
  exported.add_loss(serendipity_loss(quads, "CalculiX"));
  const PlainNames words = add_plain_names(lines, true, abaqus_set_names, exported);
  exported.bytes = AbaqusWriter(quads, frame, lines).text(type, words);
  return exported;
}

}  // namespace

Exported abaqus_cps(const QuadMesh& mesh, const Frame& frame) { return abaqus(mesh, frame, "CPS"); }
Exported abaqus_cpe(const QuadMesh& mesh, const Frame& frame) { return abaqus(mesh, frame, "CPE"); }

Exported abaqus_cax(const QuadMesh& mesh, const Frame& frame) {
  require_radii(mesh, frame);
  return abaqus(mesh, frame, "CAX");
}

}  // namespace quadrille::exports
