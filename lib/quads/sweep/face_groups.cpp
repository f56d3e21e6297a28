#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "surface/periodic_motion.hpp"
#include "sweep/swept_quads.hpp"

namespace quadrille::sweep {

namespace {

/// Of an interface that is not open, that of its curve with the lower number, from both sides.
std::string name_of(const CadFace& face, int curve, bool is_interface) {
  if (is_interface && face.is_interface(curve)) curve = std::min(curve, face.partners[curve]);
  return face.curve_names[curve].empty() ? fmt::format("curve_{}", curve) : face.curve_names[curve];
}

/// Edges of the quads with one name.
struct Side {
  std::string name;
  bool is_interface = false;
  std::vector<int> edges;  ///< of boundary_edges or interface_edges
};

std::vector<Side> sides_of(const QuadMesh& quads) {
  std::vector<Side> sides;
  std::map<std::pair<bool, std::string>, std::size_t> known;
  for (const bool is_interface : {false, true}) {
    const auto& edges = is_interface ? quads.interface_edges : quads.boundary_edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      const std::string name = name_of(quads.face, edges[e].curve, is_interface);
      const auto [entry, is_new] = known.try_emplace({is_interface, name}, sides.size());
      if (is_new) sides.push_back({name, is_interface, {}});
      sides[entry->second].edges.push_back(e);
    }
  }
  return sides;
}

/// By boundary edge: its image on the other curve of a periodic pair and the number of the pair; -1: it is not on the
/// first curve of one.
struct Images {
  std::vector<int> edge, pair;
};

Images images_of(const QuadMesh& quads) {
  std::vector<std::vector<int>> of_curve(quads.face.curves.size());
  for (std::size_t e = 0; e < quads.boundary_edges.size(); ++e)
    of_curve[quads.boundary_edges[e].curve].push_back(static_cast<int>(e));
  Images images{std::vector<int>(quads.boundary_edges.size(), -1), std::vector<int>(quads.boundary_edges.size(), -1)};
  for (std::size_t p = 0; p < quads.face.periodic_pairs.size(); ++p) {
    const auto [first, second] = quads.face.periodic_pairs[p].curves;
    if (of_curve[first].size() != of_curve[second].size()) continue;
    for (std::size_t k = 0; k < of_curve[first].size(); ++k) {
      images.edge[of_curve[first][k]] = of_curve[second][of_curve[second].size() - 1 - k];
      images.pair[of_curve[first][k]] = static_cast<int>(p);
    }
  }
  return images;
}

/// The motion of a pair in the coordinates of the CAD model.
SpaceMotion motion_of(const CadFace& face, const PeriodicPair& pair) {
  if (face.chart) return surface::periodic_motion(face, pair);
  const auto vector = [](const std::array<double, 3>& a) { return Vec3{a[0], a[1], a[2]}; };
  const Vec3 x = vector(face.plane_x), y = vector(face.plane_y), normal = normalized(cross(x, y));
  SpaceMotion motion;
  if (pair.angle != 0) motion = rotation({vector(face.plane_origin), normal}, pair.angle);
  motion.shift += pair.shift.x * x + pair.shift.y * y;
  return motion;
}

/// Whether the motion maps each node of a face onto that of the other face which is opposite along its first direction
/// if `is_reversed`.
bool maps_faces(const HexMesh& mesh, const SpaceMotion& motion, const HexFaceGroup& from, const HexFaceGroup& to,
                bool is_reversed) {
  const int n = mesh.order + 1;
  const double same = tolerance::round_off * mesh.diameter;
  for (std::size_t f = 0; f < from.elems.size(); ++f) {
    const std::vector<int> a = hex_face_nodes(mesh.order, from.faces[f]), b = hex_face_nodes(mesh.order, to.faces[f]);
    const auto node = [&](const HexFaceGroup& group, int local) {
      return mesh.nodes[mesh.elem_nodes[static_cast<std::size_t>(group.elems[f]) * mesh.nodes_per_elem() + local]];
    };
    for (int k = 0; k < n * n; ++k) {
      // The nodes of the bottom stand with both directions exchanged against those of the top.
      const int other = is_reversed ? k / n * n + n - 1 - k % n : k % n * n + k / n;
      if (!(distance(image(motion, node(from, a[k])), node(to, b[other])) <= same)) return false;
    }
  }
  return true;
}

/// The edges that are images of all edges of a side, and the one pair's motion by which; nothing if there is no such.
struct Image {
  std::vector<int> edges;
  int pair = -1;
};

std::optional<Image> image_of(const QuadMesh& quads, const Side& side, const Images& images) {
  if (side.is_interface) return std::nullopt;
  Image image;
  const auto& pairs = quads.face.periodic_pairs;
  for (const int e : side.edges) {
    if (images.edge[e] < 0) return std::nullopt;
    const PeriodicPair& pair = pairs[images.pair[e]];
    if (image.pair >= 0 && (pair.angle != pairs[image.pair].angle || !(pair.shift == pairs[image.pair].shift)))
      return std::nullopt;
    image.pair = images.pair[e];
    image.edges.push_back(images.edge[e]);
  }
  return image;
}

class GroupMaker {
 public:
  GroupMaker(const SweptQuads& swept, HexMesh& mesh) : swept_(swept), mesh_(mesh), sides_(sides_of(swept.quads)) {}

  /// Sides without an image of one name lose their periodicity: their names are added to `lost`.
  void make(std::vector<std::string>& lost) {
    const Images images = images_of(swept_.quads);
    std::vector<std::array<int, 3>> joined;  // side, its image, pair
    for (int s = 0; s < static_cast<int>(sides_.size()); ++s) {
      const std::optional<Image> image = image_of(swept_.quads, sides_[s], images);
      const int other = image ? side_with(image->edges) : -1;
      if (other < 0 || other == s) {
        note_loss(s, images, lost);
        continue;
      }
      sides_[other].edges = image->edges;
      joined.push_back({s, other, image->pair});
    }
    for (const Side& side : sides_) add_group(side);
    for (const auto& [first, second, pair] : joined) join(first, second, pair, lost);
  }

 private:
  /// The side with these edges, in any order.
  int side_with(std::vector<int> edges) const {
    std::sort(edges.begin(), edges.end());
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      std::vector<int> own = sides_[s].edges;
      std::sort(own.begin(), own.end());
      if (!sides_[s].is_interface && own == edges) return static_cast<int>(s);
    }
    return -1;
  }

  void note_loss(int side, const Images& images, std::vector<std::string>& lost) const {
    const Side& of = sides_[side];
    if (of.is_interface) return;
    if (std::any_of(of.edges.begin(), of.edges.end(), [&](int e) { return images.edge[e] >= 0; }))
      lost.push_back(of.name);
  }

  void add_group(const Side& side) {
    HexFaceGroup group{side.name, {}, {}, side.is_interface};
    const auto& edges = side.is_interface ? swept_.quads.interface_edges : swept_.quads.boundary_edges;
    for (int layer = 0; layer < mesh_.num_layers(); ++layer)
      for (const int e : side.edges) {
        group.elems.push_back(layer * mesh_.num_quads + edges[e].elem);
        group.faces.push_back(swept_.face_of_side[edges[e].side]);
      }
    mesh_.face_groups.push_back(std::move(group));
  }

  void join(int first, int second, int pair, std::vector<std::string>& lost) {
    const CadFace& face = swept_.quads.face;
    const SpaceMotion motion = motion_of(face, face.periodic_pairs[pair]);
    HexFaceGroup& group = mesh_.face_groups[first];
    if (!maps_faces(mesh_, motion, group, mesh_.face_groups[second], true)) return lost.push_back(group.name);
    group.periodic_with = second;
    group.motion = motion;
  }

  const SweptQuads& swept_;
  HexMesh& mesh_;
  std::vector<Side> sides_;
};

}  // namespace

void add_face_groups(const SweptQuads& swept, HexMesh& mesh, std::vector<std::string>& lost) {
  GroupMaker(swept, mesh).make(lost);
}

void add_ends(const std::string& bottom, const std::string& top, HexMesh& mesh) {
  const int last = mesh.num_elems() - mesh.num_quads;
  for (const bool is_top : {false, true}) {
    HexFaceGroup group;
    group.name = is_top ? top : bottom;
    for (const HexFaceGroup& other : mesh.face_groups)
      if (other.name == group.name)
        throw UsageError(
            fmt::format("'{}' is the name of a side already: give --{}-name", group.name, is_top ? "top" : "bottom"));
    for (int quad = 0; quad < mesh.num_quads; ++quad) {
      group.elems.push_back((is_top ? last : 0) + quad);
      group.faces.push_back(is_top ? 5 : 4);
    }
    mesh.face_groups.push_back(std::move(group));
  }
}

bool join_ends(const SpaceMotion& motion, HexMesh& mesh) {
  const int top = static_cast<int>(mesh.face_groups.size()) - 1;
  HexFaceGroup& bottom = mesh.face_groups[top - 1];
  if (!maps_faces(mesh, motion, bottom, mesh.face_groups[top], false)) return false;
  bottom.periodic_with = top;
  bottom.motion = motion;
  return true;
}

}  // namespace quadrille::sweep
