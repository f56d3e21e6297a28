#include "export/hex_periodic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "surface/periodic_motion.hpp"

namespace quadrille::exports {

namespace {

/// Groups that are the first ones of a pair.
std::vector<int> first_groups(const HexMesh& mesh) {
  std::vector<int> groups;
  for (int g = 0; g < static_cast<int>(mesh.face_groups.size()); ++g) {
    const int other = mesh.face_groups[g].periodic_with;
    if (other >= 0 && (other > g || mesh.face_groups[other].periodic_with != g)) groups.push_back(g);
  }
  return groups;
}

/// Vertices, edges and faces that are one.
class IdentifiedHexes {
 public:
  IdentifiedHexes(const HexMesh& mesh, const HexNumbering& numbering, Motions motions)
      : numbering_(numbering),
        vertices_(numbering.num_vertices()),
        edges_(numbering.num_edges()),
        faces_(numbering.num_faces()) {
    std::vector<int> node2vertex(mesh.nodes.size(), -1);
    for (int v = 0; v < numbering.num_vertices(); ++v) node2vertex[numbering.vertices[v]] = v;
    std::map<std::array<int, 2>, int> edges;  // by the ends
    for (int e = 0; e < numbering.num_edges(); ++e) edges[numbering.edges[e].vertices] = e;
    const int n = mesh.order, width = n + 1;
    const std::array<int, 4> corners{0, n, width * width - 1, width * n};
    for (const PeriodicFaces& pair : periodic_faces(mesh)) {
      if (motions == Motions::translations && !is_translation(mesh.face_groups[pair.group].motion)) continue;
      std::array<std::array<int, 2>, 4> ends{};
      for (int c = 0; c < 4; ++c)
        for (int side = 0; side < 2; ++side) ends[c][side] = node2vertex[pair.nodes[corners[c]][side]];
      for (int c = 0; c < 4; ++c) {
        const auto edge = [&](int side) {
          const auto [low, high] = std::minmax(ends[c][side], ends[(c + 1) % 4][side]);
          return edges.at({low, high});
        };
        vertices_.unite(ends[c][0], ends[c][1]);
        edges_.unite(edge(0), edge(1));
      }
      faces_.unite(numbering.face(pair.first.elem, pair.first.face),
                   numbering.face(pair.second.elem, pair.second.face));
    }
  }

  int vertex(int v) { return vertices_.find(v); }

  /// Whether each edge and each face differs from all others by its vertices, of which no two are one.
  bool are_known_by_vertices() {
    std::set<std::array<int, 4>> known;
    const auto is_new = [&](std::array<int, 4> key) {
      std::sort(key.begin(), key.end());
      const bool has_twice =
          std::adjacent_find(key.begin(), key.end(), [](int a, int b) { return a == b && a >= 0; }) != key.end();
      return !has_twice && known.insert(key).second;
    };
    for (int e = 0; e < numbering_.num_edges(); ++e)
      if (const auto [a, b] = numbering_.edges[e].vertices;
          edges_.find(e) == e && !is_new({vertex(a), vertex(b), -1, -1}))
        return false;
    for (int f = 0; f < numbering_.num_faces(); ++f) {
      if (faces_.find(f) != f) continue;
      std::array<int, 4> key{};
      const NumberedHexFace& face = numbering_.faces[f];
      for (int k = 0; k < 4; ++k) key[k] = vertex(numbering_.vertex(face.elem, hex_face_corners[face.face][k]));
      if (!is_new(key)) return false;
    }
    return true;
  }

 private:
  const HexNumbering& numbering_;
  DisjointSets vertices_, edges_, faces_;
};

class FacePair {
 public:
  FacePair(const HexMesh& mesh, const PeriodicFaces& faces)
      : mesh_(mesh),
        motion_(mesh.face_groups[faces.group].motion),
        first_(face_nodes(mesh, faces.first.elem, faces.first.face)),
        second_(face_nodes(mesh, faces.second.elem, faces.second.face)) {}

  /// Both faces have their outside on the reader's side, so the second one runs the other way round: its node (b, a),
  /// turned by a number of quarters.
  std::vector<std::array<int, 2>> nodes() const {
    for (int quarters = 0; quarters < 4; ++quarters)
      if (std::vector<std::array<int, 2>> pairs = pairs_after(quarters); are_images(pairs)) return pairs;
    throw ComputeError("no face of the other periodic side is the image of the face at " +
                       position_text(mesh_.nodes[first_[0]]) + ": make the mesh again (hexsweep)");
  }

 private:
  std::vector<std::array<int, 2>> pairs_after(int quarters) const {
    const int n = mesh_.order, width = n + 1;
    std::vector<std::array<int, 2>> pairs;
    for (int b = 0; b <= n; ++b)
      for (int a = 0; a <= n; ++a) {
        int i = b, j = a;
        for (int turn = 0; turn < quarters; ++turn) {
          const int before = i;
          i = n - j, j = before;
        }
        pairs.push_back({first_[b * width + a], second_[j * width + i]});
      }
    return pairs;
  }

  bool are_images(const std::vector<std::array<int, 2>>& pairs) const {
    const double same = tolerance::round_off * mesh_.diameter;
    for (const auto& [node, image] : pairs)
      if (distance(surface::image(motion_, mesh_.nodes[node]), mesh_.nodes[image]) > same) return false;
    return true;
  }

  const HexMesh& mesh_;
  const SpaceMotion& motion_;
  std::vector<int> first_, second_;
};

}  // namespace

std::vector<PeriodicFaces> periodic_faces(const HexMesh& mesh) {
  std::vector<PeriodicFaces> result;
  for (const int g : first_groups(mesh)) {
    const HexFaceGroup &group = mesh.face_groups[g], &other = mesh.face_groups[group.periodic_with];
    for (std::size_t k = 0; k < group.elems.size(); ++k) {
      PeriodicFaces faces{g, {group.elems[k], group.faces[k]}, {other.elems.at(k), other.faces.at(k)}, {}};
      faces.nodes = FacePair(mesh, faces).nodes();
      result.push_back(std::move(faces));
    }
  }
  return result;
}

bool is_translation(const SpaceMotion& motion) { return motion.matrix == SpaceMotion().matrix; }

std::string periodic_loss(const HexMesh& mesh, std::string_view why) {
  std::string list;
  for (const int g : first_groups(mesh))
    list += fmt::format("{}\"{}\" and \"{}\"", list.empty() ? "" : "; ", mesh.face_groups[g].name,
                        mesh.face_groups[mesh.face_groups[g].periodic_with].name);
  if (list.empty()) return {};
  return fmt::format("that faces are periodic is not stored, their nodes are images of each other: {}{}", list,
                     why.empty() ? "" : fmt::format(" ({})", why));
}

PeriodicVertices periodic_vertices(const HexMesh& mesh, const HexNumbering& numbering, Motions motions,
                                   const char* reader) {
  const std::vector<int> firsts = first_groups(mesh);
  if (std::none_of(firsts.begin(), firsts.end(),
                   [&](int g) { return motions == Motions::all || is_translation(mesh.face_groups[g].motion); }))
    return {};
  IdentifiedHexes hexes(mesh, numbering, motions);
  PeriodicVertices result;
  if (!hexes.are_known_by_vertices())
    result.loss = periodic_loss(
        mesh, fmt::format("{} identifies edges and faces by their vertices, which two would share: refine to at least "
                          "three elements from side to side; sides that meet in a corner stay apart",
                          reader));
  else
    for (int v = 0; v < numbering.num_vertices(); ++v) result.same.push_back(hexes.vertex(v));
  return result;
}

}  // namespace quadrille::exports
