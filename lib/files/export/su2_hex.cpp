#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/split_hexes.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

class Su2HexWriter : TextWriter {
 public:
  /// `hexes` are of order 1.
  Su2HexWriter(const HexMesh& hexes, const Groups& groups) : hexes_(hexes), groups_(groups) {}

  std::string text(const NameList& markers) {
    print("NDIME= 3\n");
    write_elements();
    write_points();
    print("NMARK= {}\n", markers.size());
    for (std::size_t k = 0; k < markers.size(); ++k) write_marker(markers[k], static_cast<int>(k));
    return std::move(out_);
  }

 private:
  void write_elements() {
    print("NELEM= {}\n", hexes_.num_elems());
    for (int elem = 0; elem < hexes_.num_elems(); ++elem) {
      print("12");  // VTK's number of a hexahedron, which SU2 uses
      for (int corner = 0; corner < 8; ++corner)
        print(" {}", hexes_.elem_nodes[8 * static_cast<std::size_t>(elem) + hex_corner_node(1, corner)]);
      print(" {}\n", elem);
    }
  }

  void write_points() {
    print("NPOIN= {}\n", hexes_.nodes.size());
    for (std::size_t node = 0; node < hexes_.nodes.size(); ++node) {
      const Vec3 x = hexes_.nodes[node];
      print("{} {} {} {}\n", x.x, x.y, x.z, node);
    }
  }

  void write_marker(const std::string& name, int boundary) {
    std::vector<GroupFace> faces;
    for (std::size_t g = 0; g < hexes_.face_groups.size(); ++g) {
      const HexFaceGroup& group = hexes_.face_groups[g];
      if (group.is_interface || groups_.curve2boundary[g] != boundary) continue;
      for (std::size_t k = 0; k < group.elems.size(); ++k) faces.push_back({group.elems[k], group.faces[k]});
    }
    print("MARKER_TAG= {}\nMARKER_ELEMS= {}\n", name, faces.size());
    for (const GroupFace at : faces) {
      print("9");  // a quad
      for (const int corner : hex_face_corners[at.face])
        print(" {}", hexes_.elem_nodes[8 * static_cast<std::size_t>(at.elem) + hex_corner_node(1, corner)]);
      print("\n");
    }
  }

  const HexMesh& hexes_;
  const Groups& groups_;
};

}  // namespace

Exported su2_mesh(const HexMesh& mesh) {
  const HexMesh hexes = split_at_nodes(mesh);
  require_valid_pieces(hexes, "SU2's cells");
  const Groups groups = mesh_groups(hexes);
  Exported exported;
  exported.add_loss(split_loss(mesh));
  exported.add_loss(interface_loss(groups));
  exported.add_loss(region_loss(groups));
  exported.add_loss(periodic_loss(mesh));
  const PlainNames words = add_plain_names(groups, false, {{"SEND_RECEIVE"}}, exported);
  exported.bytes = Su2HexWriter(hexes, groups).text(words.boundaries);
  return exported;
}

}  // namespace quadrille::exports
