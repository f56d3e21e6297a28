#include <algorithm>

#include "export/groups.hpp"
#include "export/hex_blend.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/hohqmesh.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {
namespace {

/// Trixi.jl's order of faces, -y +y -z +x +z -x, and p4est's, -x +x -y +y -z +z.
constexpr std::array<int, 6> trixi_faces{0, 2, 4, 1, 5, 3}, p4est_faces{3, 1, 0, 2, 4, 5};

class InpHexWriter : TextWriter {
 public:
  InpHexWriter(const HexMesh& mesh, const HexNumbering& numbering, const PeriodicVertices& periodic)
      : mesh_(mesh), numbering_(numbering), periodic_(periodic), group_(numbering.num_faces(), -1) {
    points_ = renoded(
        mesh, spectral::interpolation_matrix(spectral::gll_points(mesh.order), chebyshev_lobatto_points(mesh.order)));
    for (const NumberedHexFace& face : numbering.faces) is_curved_.push_back(!is_bilinear(face));
  }

  std::string text(const Groups& groups, const std::vector<std::string>& names) {
    find_names(groups);
    print(inp_heading);
    write_straight_hexes();
    print(inp_second_part, mesh_.order);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) write_faces(elem);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) write_names(elem, names);
    return std::move(out_);
  }

 private:
  /// Whether a face is what a reader draws for a straight one: its edges straight, at constant speed, and their blend.
  bool is_bilinear(const NumberedHexFace& face) const {
    for (int e = 0; e < 12; ++e) {
      const auto& corners = hex_face_corners[face.face];
      const auto has = [&](int corner) { return std::find(corners.begin(), corners.end(), corner) != corners.end(); };
      if (has(hex_edge_corners[e][0]) && has(hex_edge_corners[e][1]) &&
          !is_blend(mesh_, edge_nodes(mesh_, face.elem, e)))
        return false;
    }
    return is_blend(mesh_, face_nodes(mesh_, face.elem, face.face));
  }

  /// Faces of periodic groups that are identified lie inside the mesh.
  void find_names(const Groups& groups) {
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g)
      if (!mesh_.face_groups[g].is_interface)
        for (const GroupFace at : faces_once(mesh_.face_groups[g], numbering_))
          group_[numbering_.face(at.elem, at.face)] = groups.curve2boundary[g];
    if (!periodic_.are_identified()) return;
    for (const PeriodicFaces& pair : periodic_faces(mesh_))
      if (is_translation(mesh_.face_groups[pair.group].motion))
        for (const GroupFace at : {pair.first, pair.second}) group_[numbering_.face(at.elem, at.face)] = -1;
  }

  void write_straight_hexes() {
    print("*NODE\n");
    for (int v = 0; v < numbering_.num_vertices(); ++v) {
      const Vec3 x = mesh_.nodes[numbering_.vertices[v]];
      print("{}, {}, {}, {}\n", v + 1, x.x, x.y, x.z);
    }
    print("*ELEMENT, type=C3D8, ELSET=Volume1\n");
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      print("{}", elem + 1);
      for (int corner = 0; corner < 8; ++corner) print(", {}", periodic_(numbering_.vertex(elem, corner)) + 1);
      print("\n");
    }
  }

  void write_faces(int elem) {
    print("** ");
    for (int corner = 0; corner < 8; ++corner) print(" {}", numbering_.vertex(elem, corner) + 1);
    print("\n** ");
    for (const int face : trixi_faces) print(" {:d}", static_cast<bool>(is_curved_[numbering_.face(elem, face)]));
    print("\n");
    for (const int face : trixi_faces)
      if (is_curved_[numbering_.face(elem, face)])
        for (const int node : face_nodes(mesh_, elem, directed_hex_face_corners[face]))
          print("**  {} {} {}\n", points_[node].x, points_[node].y, points_[node].z);
  }

  void write_names(int elem, const std::vector<std::string>& names) {
    print("**");
    for (const int face : p4est_faces) {
      const int group = group_[numbering_.face(elem, face)];
      print(" {}", group < 0 ? "---" : names[group]);
    }
    print("\n");
  }

  const HexMesh& mesh_;
  const HexNumbering& numbering_;
  const PeriodicVertices& periodic_;
  std::vector<Vec3> points_;     ///< by mesh node, at Chebyshev-Lobatto points
  std::vector<bool> is_curved_;  ///< by face
  std::vector<int> group_;       ///< by face: its boundary; -1 inside
};

void report_periodic(const HexMesh& mesh, const PeriodicVertices& periodic, Exported& exported) {
  if (periodic.are_identified())
    exported.add_loss(
        "periodic faces have the same corners in *ELEMENT, from which p4est knows that they are one, and their own in "
        "the "
        "comments that Trixi.jl reads: other programs read wrong hexahedra along them");
  exported.add_loss(periodic.loss);
  const bool has_others = std::any_of(mesh.face_groups.begin(), mesh.face_groups.end(), [](const HexFaceGroup& group) {
    return group.periodic_with >= 0 && !is_translation(group.motion);
  });
  if (has_others) exported.add_loss(periodic_loss(mesh, "the solvers couple faces that are moved, not turned"));
}

}  // namespace

Exported abaqus_inp(const HexMesh& mesh) {
  const Groups groups = mesh_groups(mesh);
  const HexNumbering numbering = number_parts(mesh);
  require_known_by_vertices(mesh, numbering, "p4est");
  const PeriodicVertices periodic = periodic_vertices(mesh, numbering, Motions::translations, "p4est");
  Exported exported;
  const PlainNames plain = add_plain_names(groups, false, {}, exported);
  exported.add_loss(interface_loss(groups));
  exported.add_loss(region_loss(groups));
  if (const double moved = face_blend_loss(mesh); moved > 1e-12 * mesh.diameter)
    exported.add_loss(
        "nodes inside elements are not stored; a reader rebuilds them from the faces, which moves them by up "
        "to " +
        length_text(moved, mesh.diameter));
  report_periodic(mesh, periodic, exported);
  exported.bytes = InpHexWriter(mesh, numbering, periodic).text(groups, plain.boundaries);
  return exported;
}

}  // namespace quadrille::exports
