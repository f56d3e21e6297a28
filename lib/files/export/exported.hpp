#pragma once
// What the writer of a solver format returns, and the frame in which it writes positions.

#include <array>
#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/length_scale.hpp"

namespace quadrille::exports {

/// The name of a file beside the main one: what replaces its ending (".curves.vtu") or, if `is_appended`, follows its
/// whole name (x.re2.names.json), or, if `is_whole`, replaces it ("owner" beside "points").
struct SideName {
  std::string ending;
  bool is_appended = false, is_whole = false;
};

/// Those of all formats: the table of names, named after the whole main file so that those of two formats differ; the
/// curves, and the faces, of VTK's format; the geometry of Nek5000's; the sides of PLOT3D's grids; the parts of
/// SPECFEM2D's mesh.
inline const SideName names_table_name{".names.json", true}, vtu_curves_name{".curves.vtu"},
    vtu_faces_name{".faces.vtu"}, nek_field_name{"0.f00000"}, neutral_map_name{".nmf"}, specfem_nodes{".nodes", true},
    specfem_materials{".materials", true}, specfem_free_surface{".free_surface", true},
    specfem_absorbing{".absorbing_surface", true};

/// Those of OpenFOAM's polyMesh, beside its points.
inline const SideName poly_faces_name{"faces", false, true}, poly_owner_name{"owner", false, true},
    poly_neighbour_name{"neighbour", false, true}, poly_boundary_name{"boundary", false, true},
    poly_zones_name{"cellZones", false, true};

/// A file that a format needs beside the main one, such as a table of names.
struct SideFile {
  SideName name;
  std::string bytes;
  bool is_binary = false;
};

struct Exported {
  std::string bytes;
  bool is_binary = false;
  std::vector<SideFile> side_files;
  /// Properties of this mesh that the format cannot represent: one sentence each, with the magnitude of the loss.
  /// A file beside the main one is called * and its ending there.
  std::vector<std::string> losses;
  LengthScale length{};  ///< of the coordinates, set by export_mesh

  /// A sentence; nothing if it is empty.
  void add_loss(const std::string& loss) {
    if (!loss.empty()) losses.push_back(loss);
  }
};

/// The position of the face in space, coordinates of its plane or of the CAD model: x3d = origin + x e_x + y e_y, in
/// the unit of the file.
struct Frame {
  std::array<double, 3> origin{0, 0, 0}, x_axis{1, 0, 0}, y_axis{0, 1, 0};

  /// A position relative to face.origin, as all stage files store them.
  std::array<double, 3> at(Vec2 x) const {
    return {origin[0] + x.x * x_axis[0] + x.y * y_axis[0], origin[1] + x.x * x_axis[1] + x.y * y_axis[1],
            origin[2] + x.x * x_axis[2] + x.y * y_axis[2]};
  }

  /// Whether z = 0 everywhere and the orientation is kept, so that two coordinates suffice.
  bool is_plane() const {
    return origin[2] == 0 && x_axis[2] == 0 && y_axis[2] == 0 && x_axis[0] * y_axis[1] > x_axis[1] * y_axis[0];
  }
};

/// The face's own plane, z = 0.
inline Frame plane_frame(const CadFace& face) { return {{face.origin.x, face.origin.y, 0}, {1, 0, 0}, {0, 1, 0}}; }

/// The CAD model's space (CadFace: plane_origin, plane_x, plane_y).
inline Frame model_frame(const CadFace& face) {
  Frame frame{face.plane_origin, face.plane_x, face.plane_y};
  frame.origin = frame.at(face.origin);
  return frame;
}

}  // namespace quadrille::exports
