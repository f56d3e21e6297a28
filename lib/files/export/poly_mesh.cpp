// OpenFOAM's polyMesh of hexahedra with straight edges: points (the main file), faces, owner, neighbour, boundary and
// cellZones. Source: OpenFOAM user guide, "Mesh description".
#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "export/cells.hpp"
#include "export/hex_blend.hpp"
#include "export/hex_periodic.hpp"
#include "export/plate_mesh.hpp"
#include "export/poly_faces.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {
namespace {

/// Throws ComputeError for a cell whose straight edges do not turn right-handed at a corner.
void require_convex_corners(const HexMesh& mesh) {
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int c = 0; c < 8; ++c) {
      const auto corner = [&](int i, int j, int k) {
        const int n = mesh.order;
        return mesh.nodes[element_nodes(mesh, elem)[n * ((k * (n + 1) + j) * (n + 1) + i)]];
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
      : mesh_(mesh), faces_(poly_faces(mesh, types)), metres_(metres_or_one(mesh.length_unit)) {}

  Exported files() {
    Exported exported;
    report_losses(exported);
    const auto [patches, zones] = add_plain_names(faces_.groups, true, {}, exported);
    exported.bytes = points_file();
    exported.side_files.push_back({poly_faces_name, faces_file()});
    exported.side_files.push_back({poly_owner_name, cells_file("owner", &PolyFace::owner, true)});
    exported.side_files.push_back({poly_neighbour_name, cells_file("neighbour", &PolyFace::neighbour, false)});
    exported.side_files.push_back({poly_boundary_name, boundary_file(patches)});
    exported.side_files.push_back({poly_zones_name, zones_file(zones)});
    return exported;
  }

 private:
  void report_losses(Exported& exported) const {
    require_convex_corners(mesh_);
    double moved = 0;
    for (const NumberedEdge& edge : faces_.numbering.edges)
      moved = std::max(moved, blend_distance(mesh_, edge_nodes(mesh_, edge)));
    if (moved > 1e-12 * mesh_.diameter)
      exported.add_loss(
          fmt::format("cells have straight edges, which moves nodes by up to {}", length_text(moved, mesh_.diameter)));
    exported.add_loss(interface_loss(faces_.groups));
    if (faces_.are_periodic_lost)
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
    std::string text = header("vectorField", "points") + fmt::format("{}\n(\n", faces_.numbering.num_vertices());
    for (const int node : faces_.numbering.vertices) text += vector_text(metres_ * mesh_.nodes[node]) + '\n';
    return text + ")\n";
  }

  template <class Act>
  void for_faces(const Act& act) const {
    for (const PolyFace& face : faces_.inner) act(face);
    for (const PolyPatch& patch : faces_.patches)
      for (const PolyFace& face : patch.faces) act(face);
  }

  std::string faces_file() const {
    std::string text = header("faceList", "faces") + fmt::format("{}\n(\n", faces_.numbering.num_faces());
    for_faces([&](const PolyFace& face) {
      const auto& [a, b, c, d] = face.vertices;
      text += fmt::format("4({} {} {} {})\n", a, b, c, d);
    });
    return text + ")\n";
  }

  /// Owners of all faces, or neighbours of the inner ones.
  std::string cells_file(const char* object, int PolyFace::*cell, bool of_all) const {
    const std::string note = fmt::format("    note \"nPoints: {} nCells: {} nFaces: {} nInternalFaces: {}\";\n",
                                         faces_.numbering.num_vertices(), mesh_.num_elems(),
                                         faces_.numbering.num_faces(), faces_.inner.size());
    std::string text = header("labelList", object, note) +
                       fmt::format("{}\n(\n", of_all ? faces_.numbering.faces.size() : faces_.inner.size());
    for_faces([&](const PolyFace& face) {
      if (of_all || face.neighbour >= 0) text += fmt::format("{}\n", face.*cell);
    });
    return text + ")\n";
  }

  std::string boundary_file(const std::vector<std::string>& names) const {
    std::string text = header("polyBoundaryMesh", "boundary");
    std::size_t start = faces_.inner.size();
    text += fmt::format("{}\n(\n", faces_.patches.size());
    for (std::size_t b = 0; b < faces_.patches.size(); ++b) {
      const PolyPatch& patch = faces_.patches[b];
      text += fmt::format("    {}\n    {{\n        type {};\n", names[b], patch.type);
      if (patch.neighbour >= 0)
        text += fmt::format("        neighbourPatch {};\n", names[patch.neighbour]) + patch.entries;
      text += fmt::format("        nFaces {};\n        startFace {};\n    }}\n", patch.faces.size(), start);
      start += patch.faces.size();
    }
    return text + ")\n";
  }

  std::string zones_file(const std::vector<std::string>& names) const {
    const std::vector<std::vector<int>> cells = elements_by_region(mesh_, faces_.groups);
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
  PolyFaces faces_;
  double metres_ = 1;  ///< of the unit, 1 where that is unknown
};

}  // namespace

Exported poly_mesh(const HexMesh& mesh, const std::vector<PatchType>& types) {
  return PolyMeshWriter(mesh, types).files();
}

/// As blockMesh makes it from a blockMeshDict.
Exported poly_mesh(const QuadMesh& mesh, const Frame& frame, const std::vector<PatchType>& types) {
  const Groups groups = mesh_groups(mesh);
  require_boundaries(groups.boundary_names, types);
  const std::vector<CyclicPatch> cyclic = cyclic_patches(mesh, groups, types);
  const PlateMesh plate = plate_mesh(mesh, frame, groups, cyclic, types);
  Exported exported = poly_mesh(plate.mesh, plate.types);
  if (const double moved = boundary_distance(mesh); moved > 1e-12 * mesh.face.diameter)
    exported.add_loss(straight_sides_loss(moved, mesh.face.diameter));
  exported.add_loss(cyclic_loss(mesh.face, groups, cyclic,
                                "a cyclic patch has periodic curves of one motion only, and no type by --patch-type"));
  return exported;
}

}  // namespace quadrille::exports
