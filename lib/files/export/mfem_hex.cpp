#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "export/mfem_text.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// MFEM's numbers of its geometries (geom.hpp of its source).
constexpr int face_type = 3, cube_type = 5;

HexNumbering mfem_numbering(const HexMesh& mesh) {
  HexNumbering numbering = number_hexes(mesh);
  require_known_by_vertices(mesh, numbering, "MFEM");
  return numbering;
}

class MfemHexWriter : public MfemWriter<HexMesh, HexNumbering> {
 public:
  MfemHexWriter(const HexMesh& mesh, bool with_names) : MfemWriter(mesh, mfem_numbering(mesh), 3, with_names) {}

 private:
  void print_corner(int elem, int corner) { print(" {}", vertex_numbers_[numbering_.vertex(elem, corner)]); }

  void write_elements() override {
    print("\nelements\n{}\n", mesh_.num_elems());
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      print("{} {}", 1 + groups_.block2region[mesh_.quad_block[elem % mesh_.num_quads]], cube_type);
      for (int corner = 0; corner < 8; ++corner) print_corner(elem, corner);
      print("\n");
    }
  }

  void write_boundary() override {
    std::vector<std::vector<GroupFace>> faces;
    std::size_t count = 0;
    for (const HexFaceGroup& group : mesh_.face_groups) {
      faces.push_back(faces_once(group, numbering_));
      count += faces.back().size();
    }
    print("\nboundary\n{}\n", count);
    for (std::size_t g = 0; g < faces.size(); ++g)
      for (const GroupFace at : faces[g]) {
        print("{} {}", 1 + groups_.curve2boundary[g], face_type);
        for (const int corner : hex_face_corners[at.face]) print_corner(at.elem, corner);
        print("\n");
      }
  }

  void print_position(int node) override {
    const Vec3 x = mesh_.nodes[node];
    print("{} {} {}\n", x.x, x.y, x.z);
  }

  int space_dim() const override { return 3; }

  /// Edges (each in its own direction), faces as the element of lower number sees them,
  /// elements (the first coordinate fastest).
  void write_inner_nodes() override {
    const int n = mesh_.order, width = n + 1;
    for (const NumberedHexEdge& edge : numbering_.edges) {
      const std::vector<int> nodes = edge_nodes(mesh_, edge);
      for (int k = 1; k < n; ++k) print_position(nodes[k]);
    }
    for (const NumberedHexFace& face : numbering_.faces) {
      const std::vector<int> nodes = face_nodes(mesh_, face.elem, face.face);
      for (int b = 1; b < n; ++b)
        for (int a = 1; a < n; ++a) print_position(nodes[b * width + a]);
    }
    for (std::size_t first = 0; first < mesh_.elem_nodes.size(); first += mesh_.nodes_per_elem())
      for (int k = 1; k < n; ++k)
        for (int j = 1; j < n; ++j)
          for (int i = 1; i < n; ++i) print_position(mesh_.elem_nodes[first + (k * width + j) * width + i]);
  }
};

}  // namespace

Exported mfem_mesh10(const HexMesh& mesh) { return MfemHexWriter(mesh, false).exported(); }
Exported mfem_mesh13(const HexMesh& mesh) { return MfemHexWriter(mesh, true).exported(); }

}  // namespace quadrille::exports
