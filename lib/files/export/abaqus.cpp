#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "export/cells.hpp"
#include "export/hex_periodic.hpp"
#include "export/renode.hpp"
#include "export/serendipity.hpp"
#include "export/split_elements.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// CalculiX' greatest length of the name of a set; upper and lower case are the same.
const WordRules abaqus_set_names{{"NALL", "EALL"}, 80, true};

/// The places of the nodes among those of an element of order 1 or 2: corners, then middles: of sides
/// counter-clockwise; of edges below, above and upright.
std::vector<int> abaqus_places(const QuadMesh& mesh) {
  if (mesh.order == 1) return {0, 1, 3, 2};
  return {0, 2, 8, 6, 1, 5, 7, 3};
}
std::vector<int> abaqus_places(const HexMesh& mesh) {
  if (mesh.order == 1) return {0, 1, 3, 2, 4, 5, 7, 6};
  return {0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15};
}

/// Sides of quads in their order; of hexahedra S1 is the bottom, S2 the top, S3 to S6 are the sides of the quad.
int surface_number(const QuadMesh&, int side) { return side + 1; }
int surface_number(const HexMesh&, int face) { return face < 4 ? face + 3 : face - 3; }

/// The shortest digits that read back to the same bits or, if those are more than CalculiX reads, as many as fit.
std::string short_number(double x) {
  constexpr std::size_t longest = 20;
  std::string text = fmt::format("{}", x);
  for (int digits = 17; text.size() > longest; --digits) text = fmt::format("{:.{}g}", x, digits);
  return text;
}

/// Of a mesh of order 1 or 2.
template <typename Mesh>
class AbaqusWriter : TextWriter {
 public:
  /// `groups` with interfaces as boundaries.
  AbaqusWriter(const Mesh& mesh, const Groups& groups)
      : mesh_(mesh), groups_(groups), places_(abaqus_places(mesh)), numbers_(serendipity_numbers(mesh)) {}

  /// `type` without the number of nodes.
  std::string text(const std::vector<std::array<double, 3>>& positions, const char* type, const PlainNames& words) {
    print("*HEADING\n{} of order {}\n*NODE, NSET=NALL\n", mesh_dimension<Mesh> == 2 ? "quadrilaterals" : "hexahedra",
          mesh_.order);
    for (std::size_t node = 0; node < numbers_.size(); ++node)
      if (const auto& x = positions[node]; numbers_[node] > 0)
        print("{}, {}, {}, {}\n", numbers_[node], short_number(x[0]), short_number(x[1]),
              short_number(mesh_dimension<Mesh> == 2 ? 0 : x[2]));
    write_elements(type, words.regions);
    const std::vector<std::vector<GroupSide>> sides = sides_by_group(mesh_, groups_);
    for (std::size_t k = 0; k < sides.size(); ++k)
      if (!sides[k].empty()) write_sides(words.boundaries[k], sides[k]);
    return std::move(out_);
  }

 private:
  /// At most 16 numbers in a line, which goes on after a comma.
  void write_elements(const char* type, const NameList& regions) {
    const std::vector<std::vector<int>> elems = elements_by_region(mesh_, groups_);
    for (std::size_t r = 0; r < regions.size(); ++r) {
      print("*ELEMENT, TYPE={}{}, ELSET={}\n", type, places_.size(), regions[r]);
      for (const int elem : elems[r]) {
        print("{}", elem + 1);
        for (std::size_t k = 0; k < places_.size(); ++k)
          print("{}{}", k == 15 ? ",\n" : ", ", numbers_[element_nodes(mesh_, elem)[places_[k]]]);
        print("\n");
      }
    }
    print("*ELSET, ELSET=EALL\n");
    for (const std::string& region : regions) print("{}\n", region);
  }

  void write_sides(const std::string& name, const std::vector<GroupSide>& sides) {
    std::vector<int> numbers;
    for (const GroupSide& at : sides)
      for (const int node : side_nodes(mesh_, at.elem, at.side))
        if (numbers_[node] > 0) numbers.push_back(numbers_[node]);
    print_node_set(name, std::move(numbers));
    print("*SURFACE, NAME={}, TYPE=ELEMENT\n", name);
    for (const GroupSide& at : sides) print("{}, S{}\n", at.elem + 1, surface_number(mesh_, at.side));
  }

  /// Sorted, each once.
  void print_node_set(const std::string& name, std::vector<int> numbers) {
    constexpr int numbers_a_line = 16;
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    print("*NSET, NSET={}\n", name);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      print("{}{}", numbers[k], (k + 1) % numbers_a_line == 0 || k + 1 == numbers.size() ? "\n" : ", ");
  }

  const Mesh& mesh_;
  const Groups& groups_;
  std::vector<int> places_;
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
  exported.bytes = AbaqusWriter(quads, lines).text(positions(quads, frame, ElementPoints::nodes), type, words);
  return exported;
}

}  // namespace

Exported abaqus_cps(const QuadMesh& mesh, const Frame& frame) { return abaqus(mesh, frame, "CPS"); }
Exported abaqus_cpe(const QuadMesh& mesh, const Frame& frame) { return abaqus(mesh, frame, "CPE"); }

Exported abaqus_cax(const QuadMesh& mesh, const Frame& frame) {
  require_radii(mesh, frame);
  return abaqus(mesh, frame, "CAX");
}

Exported abaqus_c3d(const HexMesh& mesh) {
  const Groups faces = lines_as_boundaries(mesh_groups(mesh));
  Exported exported;
  exported.add_loss(serendipity_loss(mesh, "CalculiX"));
  exported.add_loss(periodic_loss(mesh));
  const PlainNames words = add_plain_names(faces, true, abaqus_set_names, exported);
  exported.bytes = AbaqusWriter(mesh, faces).text(positions(mesh, ElementPoints::nodes), "C3D", words);
  return exported;
}

}  // namespace quadrille::exports
