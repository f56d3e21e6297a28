#include <utility>

#include "export/cells.hpp"
#include "export/hex_periodic.hpp"
#include "export/renode.hpp"
#include "export/split_elements.hpp"
#include "export/split_hexes.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// VTK's numbers of segments, quads and hexahedra, which SU2 uses, by dimension.
constexpr std::array<int, 4> cell_numbers{0, 3, 9, 12};

/// Cells are of order 1.
template <typename Mesh>
class Su2Writer : TextWriter {
 public:
  Su2Writer(const Mesh& cells, const Groups& groups) : cells_(cells), groups_(groups) {}

  std::string text(const std::vector<std::array<double, 3>>& positions, const NameList& markers) {
    print("NDIME= {}\n", dim);
    write_elements();
    print("NPOIN= {}\n", positions.size());
    for (std::size_t node = 0; node < positions.size(); ++node) {
      for (int c = 0; c < dim; ++c) print("{} ", positions[node][c]);
      print("{}\n", node);
    }
    print("NMARK= {}\n", markers.size());
    const std::vector<std::vector<GroupSide>> sides = sides_by_group(cells_, groups_);
    for (std::size_t k = 0; k < markers.size(); ++k) write_marker(markers[k], sides[k]);
    return std::move(out_);
  }

 private:
  static constexpr int dim = mesh_dimension<Mesh>;

  void write_elements() {
    print("NELEM= {}\n", cells_.num_elems());
    for (int elem = 0; elem < cells_.num_elems(); ++elem) {
      print("{}", cell_numbers[dim]);
      for (int corner = 0; corner < 1 << dim; ++corner) print(" {}", corner_node(cells_, elem, corner));
      print(" {}\n", elem);
    }
  }

  /// Markers are the boundary: an interface of the same name is no part of them.
  void write_marker(const std::string& name, std::vector<GroupSide> sides) {
    std::erase_if(sides, [](const GroupSide& at) { return at.is_interface; });
    print("MARKER_TAG= {}\nMARKER_ELEMS= {}\n", name, sides.size());
    for (const GroupSide& at : sides) {
      print("{}", cell_numbers[dim - 1]);
      for (const int corner : side_corners(cells_, at.side)) print(" {}", corner_node(cells_, at.elem, corner));
      print("\n");
    }
  }

  const Mesh& cells_;
  const Groups& groups_;
};

/// The names and what is lost of them; then the file.
template <typename Mesh>
void write_su2(const Mesh& cells, const std::vector<std::array<double, 3>>& positions, Exported& exported) {
  const Groups groups = mesh_groups(cells);
  exported.add_loss(interface_loss(groups));
  exported.add_loss(region_loss(groups));
  if constexpr (mesh_dimension<Mesh> == 3) exported.add_loss(periodic_loss(cells));
  const PlainNames words = add_plain_names(groups, false, {{"SEND_RECEIVE"}}, exported);
  exported.bytes = Su2Writer(cells, groups).text(positions, words.boundaries);
}

}  // namespace

Exported su2_mesh(const QuadMesh& mesh, const Frame& frame) {
  const QuadMesh quads = split_at_nodes(mesh);
  require_valid_pieces(quads, "SU2's cells");
  Exported exported;
  exported.add_loss(split_loss(mesh, quads));
  write_su2(quads, positions(quads, frame, ElementPoints::nodes), exported);
  return exported;
}

Exported su2_mesh(const HexMesh& mesh) {
  const HexMesh hexes = split_at_nodes(mesh);
  require_valid_pieces(hexes, "SU2's cells");
  Exported exported;
  exported.add_loss(split_loss(mesh));
  write_su2(hexes, positions(hexes, ElementPoints::nodes), exported);
  return exported;
}

}  // namespace quadrille::exports
