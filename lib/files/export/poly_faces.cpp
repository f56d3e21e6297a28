#include "export/poly_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "export/hex_periodic.hpp"

namespace quadrille::exports {

namespace {

PolyFace poly_face(const HexNumbering& numbering, GroupFace at) {
  PolyFace face{{}, at.elem, -1};
  for (int k = 0; k < 4; ++k) face.vertices[k] = numbering.vertex(at.elem, hex_face_corners[at.face][k]);
  return face;
}

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

/// The entries of a translation or of a rotation about an axis from a patch to its neighbour; no value for others.
/// `diameter`: of the mesh, which rounding errors of the motion are parts of.
std::optional<std::string> transform_entries(const SpaceMotion& motion, double diameter, double scale, bool is_forth) {
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
  if (std::abs(dot(axis, motion.shift)) > tolerance::round_off * diameter) return std::nullopt;  // a screw
  const Vec3 centre = 0.5 * scale * (motion.shift + (1 + cosine) / sine * cross(axis, motion.shift));
  return fmt::format("        transform rotational;\n        rotationAxis {};\n        rotationCentre {};\n",
                     vector_text(axis), vector_text(centre));
}

/// The parts of one PolyFaces, and what the pairs of patches need.
class FaceSorter {
 public:
  FaceSorter(const HexMesh& mesh, const std::vector<PatchType>& types) : mesh_(mesh), types_(types) {
    result_.groups = mesh_groups(mesh);
    result_.numbering = number_parts(mesh);
    result_.inner = inner_faces(result_.numbering);
    make_patches();
    couple_patches();
  }

  PolyFaces result() { return std::move(result_); }

 private:
  void make_patches() {
    const std::vector<std::string> names = patch_types(mesh_, result_.groups, types_);
    result_.patches.resize(names.size());
    std::size_t count = result_.inner.size();
    for (std::size_t b = 0; b < names.size(); ++b) result_.patches[b].type = names[b];
    for (std::size_t g = 0; g < mesh_.face_groups.size(); ++g)
      if (!mesh_.face_groups[g].is_interface)
        for (const GroupFace at : faces_once(mesh_.face_groups[g], result_.numbering)) {
          result_.patches[result_.groups.curve2boundary[g]].faces.push_back(poly_face(result_.numbering, at));
          ++count;
        }
    if (count != result_.numbering.faces.size())
      throw ComputeError("a face of the boundary is in no group or in two: make the mesh again (hexsweep)");
  }

  void couple_patches() {
    const HexNumbering& numbering = result_.numbering;
    std::map<int, std::vector<PeriodicFaces>> pairs;  // by the first group
    for (PeriodicFaces& pair : periodic_faces(mesh_)) pairs[pair.group].push_back(std::move(pair));
    vertex_of_.assign(mesh_.nodes.size(), -1);
    for (int v = 0; v < numbering.num_vertices(); ++v) vertex_of_[numbering.vertices[v]] = v;
    for (const auto& [group, faces] : pairs)
      if (!couple_pair(mesh_.face_groups[group], result_.groups.curve2boundary[group], faces))
        result_.are_periodic_lost = true;
  }

  /// False if the pair is not one of whole patches, of a type of its own, with one translation or rotation.
  bool couple_pair(const HexFaceGroup& group, int from, const std::vector<PeriodicFaces>& faces) {
    const int to = result_.groups.curve2boundary[group.periodic_with];
    const double metres = metres_or_one(mesh_.length_unit);
    const std::optional<std::string> forth = transform_entries(group.motion, mesh_.diameter, metres, true);
    PolyPatch &first = result_.patches[from], &second = result_.patches[to];
    const std::vector<std::string>& names = result_.groups.boundary_names;
    if (!forth || from == to || is_type_chosen(names[from], types_) || is_type_chosen(names[to], types_) ||
        faces.size() != first.faces.size() || faces.size() != second.faces.size())
      return false;
    first.faces.clear(), second.faces.clear();
    for (const PeriodicFaces& pair : faces) {
      first.faces.push_back(poly_face(result_.numbering, pair.first));
      second.faces.push_back(image_of(pair));
    }
    first.type = second.type = "cyclic";
    first.neighbour = to, second.neighbour = from;
    first.is_first = true;
    first.motion = second.motion = group.motion;
    first.entries = *forth;
    second.entries = *transform_entries(group.motion, mesh_.diameter, metres, false);
    return true;
  }

  /// The second face, which begins at the image of the first vertex of the first one, the other way round.
  PolyFace image_of(const PeriodicFaces& pair) const {
    const int n = mesh_.order;
    PolyFace image{{}, pair.second.elem, -1};
    const std::array<int, 4> corners{0, n * (n + 1), (n + 1) * (n + 1) - 1, n};
    for (int k = 0; k < 4; ++k) image.vertices[k] = vertex_of_[pair.nodes[corners[k]][1]];
    return image;
  }

  const HexMesh& mesh_;
  const std::vector<PatchType>& types_;
  std::vector<int> vertex_of_;  ///< by mesh node
  PolyFaces result_;
};

}  // namespace

PolyFaces poly_faces(const HexMesh& mesh, const std::vector<PatchType>& types) {
  return FaceSorter(mesh, types).result();
}

std::string vector_text(Vec3 x) { return fmt::format("({} {} {})", x.x + 0.0, x.y + 0.0, x.z + 0.0); }

mesh::StraightCells straight_cells(const HexMesh& mesh, const PolyFaces& faces) {
  mesh::StraightCells cells;
  cells.num_cells = mesh.num_elems();
  for (const int node : faces.numbering.vertices) cells.points.push_back(mesh.nodes[node]);
  const auto add = [&](const PolyFace& face) { cells.faces.push_back({face.vertices, face.owner, face.neighbour}); };
  for (const PolyFace& face : faces.inner) add(face);
  std::vector<int> starts;
  for (const PolyPatch& patch : faces.patches) {
    starts.push_back(static_cast<int>(cells.faces.size()));
    for (const PolyFace& face : patch.faces) add(face);
  }
  for (std::size_t b = 0; b < faces.patches.size(); ++b) {
    const PolyPatch& patch = faces.patches[b];
    const int count = static_cast<int>(patch.faces.size());
    for (int k = 0; k < count && patch.is_first; ++k)
      cells.coupled.push_back({starts[b] + k, starts[patch.neighbour] + k, patch.motion});
    if (patch.type != "symmetryPlane") continue;
    cells.planes.emplace_back(count);
    std::iota(cells.planes.back().begin(), cells.planes.back().end(), starts[b]);
  }
  return cells;
}

}  // namespace quadrille::exports
