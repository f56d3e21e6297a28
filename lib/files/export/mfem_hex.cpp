#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/mfem_text.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// MFEM's numbers of its geometries (geom.hpp of its source).
constexpr int face_type = 3, cube_type = 5;

class MfemHexWriter : MfemText {
 public:
  MfemHexWriter(const HexMesh& mesh, bool with_names)
      : mesh_(mesh), with_names_(with_names), numbering_(number_hexes(mesh)), groups_(mesh_groups(mesh)) {
    require_known_by_vertices(mesh_, numbering_, "MFEM");
    periodic_ = periodic_vertices(mesh_, numbering_, Motions::all, "MFEM");
    for (int v = 0; v < numbering_.num_vertices(); ++v)
      vertex_numbers_.push_back(periodic_(v) == v ? num_vertices_++ : vertex_numbers_[periodic_(v)]);
  }

  /// That faces are periodic, if the file does not store it; else empty.
  const std::string& periodic_loss() const { return periodic_.loss; }

  std::string text() {
    begin(with_names_, 3);
    write_elements();
    if (with_names_) write_sets("attribute_sets", groups_.region_names);
    write_boundary();
    if (with_names_) write_sets("bdr_attribute_sets", boundary_and_interface_names(groups_));
    write_geometry();
    if (with_names_) print("\nmfem_mesh_end\n");
    return std::move(out_);
  }

 private:
  void print_corner(int elem, int corner) { print(" {}", vertex_numbers_[numbering_.vertex(elem, corner)]); }

  void write_elements() {
    print("\nelements\n{}\n", mesh_.num_elems());
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      print("{} {}", 1 + groups_.block2region[mesh_.quad_block[elem % mesh_.num_quads]], cube_type);
      for (int corner = 0; corner < 8; ++corner) print_corner(elem, corner);
      print("\n");
    }
  }

  /// As for quads, MFEM's boundary may have elements inside the mesh.
  void write_boundary() {
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

  void print_position(int node) {
    const Vec3 x = mesh_.nodes[node];
    print("{} {} {}\n", x.x, x.y, x.z);
  }

  void write_geometry() {
    print("\nvertices\n{}\n", num_vertices_);
    if (periodic_.are_identified()) {
      write_space("L2_T1", 3, mesh_.order, 3);
      for (const int node : mesh_.elem_nodes) print_position(node);
      return;
    }
    if (mesh_.order == 1)
      print("3\n");
    else
      write_space("H1", 3, mesh_.order, 3);
    for (const int node : numbering_.vertices) print_position(node);
    if (mesh_.order > 1) write_inner_nodes();
  }

  /// MFEM's own order: vertices, edges (each in its own direction), faces as the element of lower number sees them,
  /// elements (the first coordinate fastest).
  void write_inner_nodes() {
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

  const HexMesh& mesh_;
  bool with_names_;
  HexNumbering numbering_;
  Groups groups_;
  PeriodicVertices periodic_;
  std::vector<int> vertex_numbers_;  ///< by vertex of numbering_
  int num_vertices_ = 0;
};

Exported mfem_mesh(const HexMesh& mesh, bool with_names) {
  MfemHexWriter writer(mesh, with_names);
  Exported result;
  result.bytes = writer.text();
  result.add_loss(writer.periodic_loss());
  return result;
}

}  // namespace

Exported mfem_mesh10(const HexMesh& mesh) {
  Exported result = mfem_mesh(mesh, false);
  add_mfem_names(mesh_groups(mesh), result);
  return result;
}

Exported mfem_mesh13(const HexMesh& mesh) { return mfem_mesh(mesh, true); }

}  // namespace quadrille::exports
