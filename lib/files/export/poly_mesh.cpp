// OpenFOAM's polyMesh of hexahedra with straight edges: points (the main file), faces, owner, neighbour, boundary and
// cellZones. Source: OpenFOAM user guide, "Mesh description".
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "export/groups.hpp"
#include "export/hex_blend.hpp"
#include "export/hex_numbering.hpp"
#include "export/hex_periodic.hpp"
#include "export/patches.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

struct PolyFace {
  std::array<int, 4> vertices{};  ///< the outside of the owner on the reader's side
  int owner = 0, neighbour = -1;
};

struct PolyPatch {
  std::string type = "patch", entries;  ///< the entries of a cyclic patch behind its type
  std::vector<PolyFace> faces;
};

PolyFace poly_face(const HexNumbering& numbering, GroupFace at) {
  PolyFace face{{}, at.elem, -1};
  for (int k = 0; k < 4; ++k) face.vertices[k] = numbering.vertex(at.elem, hex_face_corners[at.face][k]);
  return face;
}

/// By owner, then by neighbour, as OpenFOAM's matrices are stored.
std::vector<PolyFace> inner_faces(const HexNumbering& numbering) {
  std::vector<PolyFace> faces;
  for (const NumberedHexFace& face : numbering.faces)
    if (face.other_elem >= 0) {
      faces.push_back(poly_face(numbering, {face.elem, face.face}));
      faces.back().neighbour = face.other_elem;
    }
  std::stable_sort(faces.begin(), faces.end(), [](const PolyFace& a, const PolyFace& b) {
    return std::pair(a.owner, a.neighbour) < std::pair(b.owner, b.neighbour);
  });
  return faces;
}

std::string vector_text(Vec3 x) { return fmt::format("({} {} {})", x.x + 0.0, x.y + 0.0, x.z + 0.0); }

/// The entries of a translation or of a rotation about an axis from a patch to its neighbour; no value for others.
std::optional<std::string> transform_entries(const SpaceMotion& motion, double scale, bool is_forth) {
  const auto& [x, y, z] = motion.matrix;
  if (is_translation(motion)) {
    const Vec3 way = (is_forth ? scale : -scale) * motion.shift;
    return fmt::format("        transform translational;\n        separationVector {};\n        separation {};\n",
                       vector_text(way), vector_text(-way));
  }
  const Vec3 twice_sine{z.y - y.z, x.z - z.x, y.x - x.y};  // times the axis
  const double sine = norm(twice_sine) / 2, cosine = (x.x + y.y + z.z - 1) / 2;
  if (sine < tolerance::same_angle) return std::nullopt;
  const Vec3 axis = normalized(twice_sine);
  if (std::abs(dot(axis, motion.shift)) > tolerance::round_off * norm(motion.shift)) return std::nullopt;  // a screw
  const Vec3 centre = 0.5 * scale * (motion.shift + (1 + cosine) / sine * cross(axis, motion.shift));
  return fmt::format("        transform rotational;\n        rotationAxis {};\n        rotationCentre {};\n",
                     vector_text(axis), vector_text(centre));
}

/// Throws ComputeError for a cell whose straight edges do not turn right-handed at a corner.
void require_convex_corners(const HexMesh& mesh) {
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int c = 0; c < 8; ++c) {
      const auto corner = [&](int i, int j, int k) {
        const int n = mesh.order, local = n * ((k * (n + 1) + j) * (n + 1) + i);
        return mesh.nodes[mesh.elem_nodes[static_cast<std::size_t>(elem) * mesh.nodes_per_elem() + local]];
      };
      const auto [i, j, k] = hex_corner_indices[c];
      const Vec3 along = corner(1, j, k) - corner(0, j, k), across = corner(i, 1, k) - corner(i, 0, k);
      if (!(dot(cross(along, across), corner(i, j, 1) - corner(i, j, 0)) > 0))
        throw ComputeError("with straight edges the hexahedron at " + position_text(corner(i, j, k)) +
                           " is not convex, and OpenFOAM's cells have such edges: refine the mesh");
    }
}

class PolyMeshWriter {
 public:
  PolyMeshWriter(const HexMesh& mesh, const std::vector<PatchType>& types)
      : mesh_(mesh), groups_(mesh_groups(mesh)), numbering_(number_hexes(mesh)), inner_(inner_faces(numbering_)) {
    metres_ = metres_or_one(mesh.length_unit);
    make_patches(types);
  }

  Exported files() {
    Exported exported;
    report_losses(exported);
    const auto [patches, zones] = add_plain_names(groups_, true, {}, exported);
    exported.bytes = points_file();
    exported.side_files.push_back({poly_faces_name, faces_file()});
    exported.side_files.push_back({poly_owner_name, cells_file("owner", &PolyFace::owner, true)});
    exported.side_files.push_back({poly_neighbour_name, cells_file("neighbour", &PolyFace::neighbour, false)});
    exported.side_files.push_back({poly_boundary_name, boundary_file(patches)});
    exported.side_files.push_back({poly_zones_name, zones_file(zones)});
    return exported;
  }

 private:
  void make_patches(const std::vector<PatchType>& types) {
    patches_.resize(groups_.num_boundaries());
    const std::vector<std::string> names = patch_types(mesh_, groups_, types);
    std::size_t count = inner_.size();
    for (std::size_t b = 0; b < patches_.size(); ++b) patches_[b].type = names[b];
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g)
      if (!mesh_.face_groups[g].is_interface)
        for (const GroupFace at : faces_once(mesh_.face_groups[g], numbering_)) {
          patches_[groups_.curve2boundary[g]].faces.push_back(poly_face(numbering_, at));
          ++count;
        }
    if (count != numbering_.faces.size())
      throw ComputeError("a face of the boundary is in no group or in two: make the mesh again (hexsweep)");
    couple_patches(types);
  }

  /// A pair of groups is a pair of cyclic patches if each is the whole patch of its name. Faces of the second one are
  /// in the order of their partners, and begin at the image of their first vertex.
  void couple_patches(const std::vector<PatchType>& types) {
    std::map<int, std::vector<PeriodicFaces>> pairs;  // by the first group
    for (PeriodicFaces& pair : periodic_faces(mesh_)) pairs[pair.group].push_back(std::move(pair));
    std::vector<int> vertex_of(mesh_.nodes.size(), -1);
    for (int v = 0; v < numbering_.num_vertices(); ++v) vertex_of[numbering_.vertices[v]] = v;
    for (const auto& [group, faces] : pairs) {
      const SpaceMotion& motion = mesh_.face_groups[group].motion;
      const int first = groups_.curve2boundary[group],
                second = groups_.curve2boundary[mesh_.face_groups[group].periodic_with];
      const std::optional<std::string> forth = transform_entries(motion, metres_, true);
      if (!forth || first == second || is_type_chosen(groups_.boundary_names[first], types) ||
          is_type_chosen(groups_.boundary_names[second], types) || faces.size() != patches_[first].faces.size() ||
          faces.size() != patches_[second].faces.size()) {
        is_periodic_lost_ = true;
        continue;
      }
      patches_[first].faces.clear(), patches_[second].faces.clear();
      const int n = mesh_.order;
      for (const PeriodicFaces& pair : faces) {
        patches_[first].faces.push_back(poly_face(numbering_, pair.first));
        PolyFace image{{}, pair.second.elem, -1};
        const std::array<int, 4> corners{0, n * (n + 1), (n + 1) * (n + 1) - 1, n};  // the other way round
        for (int k = 0; k < 4; ++k) image.vertices[k] = vertex_of[pair.nodes[corners[k]][1]];
        patches_[second].faces.push_back(image);
      }
      patches_[first].type = patches_[second].type = "cyclic";
      neighbours_[first] = second, neighbours_[second] = first;
      patches_[first].entries = *forth;
      patches_[second].entries = *transform_entries(motion, metres_, false);
    }
  }

  void report_losses(Exported& exported) const {
    require_convex_corners(mesh_);
    double moved = 0;
    for (const NumberedHexEdge& edge : numbering_.edges)
      moved = std::max(moved, blend_distance(mesh_, edge_nodes(mesh_, edge)));
    if (moved > 1e-12 * mesh_.diameter)
      exported.add_loss(
          fmt::format("cells have straight edges, which moves nodes by up to {}", length_text(moved, mesh_.diameter)));
    exported.add_loss(interface_loss(groups_));
    if (is_periodic_lost_)
      exported.add_loss(periodic_loss(mesh_,
                                      "some are no cyclic patches: these have all faces of their name, one translation "
                                      "or rotation, and no type by --patch-type"));
  }

  static std::string header(const char* type, const char* object, const std::string& note = {}) {
    return fmt::format(
        "FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {};\n{}    location \"constant/polyMesh\";\n    "
        "object {};\n}}\n\n",
        type, note, object);
  }

  std::string points_file() const {
    std::string text = header("vectorField", "points") + fmt::format("{}\n(\n", numbering_.num_vertices());
    for (const int node : numbering_.vertices) text += vector_text(metres_ * mesh_.nodes[node]) + '\n';
    return text + ")\n";
  }

  template <class Act>
  void for_faces(const Act& act) const {
    for (const PolyFace& face : inner_) act(face);
    for (const PolyPatch& patch : patches_)
      for (const PolyFace& face : patch.faces) act(face);
  }

  std::string faces_file() const {
    std::string text = header("faceList", "faces") + fmt::format("{}\n(\n", numbering_.num_faces());
    for_faces([&](const PolyFace& face) {
      const auto& [a, b, c, d] = face.vertices;
      text += fmt::format("4({} {} {} {})\n", a, b, c, d);
    });
    return text + ")\n";
  }

  /// Owners of all faces, or neighbours of the inner ones.
  std::string cells_file(const char* object, int PolyFace::*cell, bool of_all) const {
    const std::string note =
        fmt::format("    note \"nPoints: {} nCells: {} nFaces: {} nInternalFaces: {}\";\n", numbering_.num_vertices(),
                    mesh_.num_elems(), numbering_.num_faces(), inner_.size());
    std::string text =
        header("labelList", object, note) + fmt::format("{}\n(\n", of_all ? numbering_.faces.size() : inner_.size());
    for_faces([&](const PolyFace& face) {
      if (of_all || face.neighbour >= 0) text += fmt::format("{}\n", face.*cell);
    });
    return text + ")\n";
  }

  std::string boundary_file(const std::vector<std::string>& names) const {
    std::string text = header("polyBoundaryMesh", "boundary");
    std::size_t start = inner_.size();
    text += fmt::format("{}\n(\n", patches_.size());
    for (std::size_t b = 0; b < patches_.size(); ++b) {
      const PolyPatch& patch = patches_[b];
      text += fmt::format("    {}\n    {{\n        type {};\n", names[b], patch.type);
      if (const auto neighbour = neighbours_.find(static_cast<int>(b)); neighbour != neighbours_.end())
        text += fmt::format("        neighbourPatch {};\n", names[neighbour->second]) + patch.entries;
      text += fmt::format("        nFaces {};\n        startFace {};\n    }}\n", patch.faces.size(), start);
      start += patch.faces.size();
    }
    return text + ")\n";
  }

  std::string zones_file(const std::vector<std::string>& names) const {
    std::vector<std::vector<int>> cells(groups_.num_regions());
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      cells[groups_.block2region[mesh_.quad_block[elem % mesh_.num_quads]]].push_back(elem);
    std::string text = header("regIOobject", "cellZones") + fmt::format("{}\n(\n", cells.size());
    for (std::size_t r = 0; r < cells.size(); ++r) {
      text += fmt::format("    {}\n    {{\n        type cellZone;\n        cellLabels List<label> {}\n        (\n",
                          names[r], cells[r].size());
      for (const int elem : cells[r]) text += fmt::format("            {}\n", elem);
      text += "        );\n    }\n";
    }
    return text + ")\n";
  }

  const HexMesh& mesh_;
  Groups groups_;
  HexNumbering numbering_;
  std::vector<PolyFace> inner_;
  std::vector<PolyPatch> patches_;  ///< by boundary
  std::map<int, int> neighbours_;   ///< of cyclic patches
  bool is_periodic_lost_ = false;
  double metres_ = 1;  ///< of the unit, 1 where that is unknown
};

}  // namespace

Exported poly_mesh(const HexMesh& mesh, const std::vector<PatchType>& types) {
  return PolyMeshWriter(mesh, types).files();
}

}  // namespace quadrille::exports
