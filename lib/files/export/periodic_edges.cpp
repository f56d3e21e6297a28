#include "export/periodic_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "model/periodic.hpp"
#include "model/quad_mesh.hpp"
#include "surface/periodic_motion.hpp"
#include "surface/positions.hpp"

namespace quadrille::exports {

namespace {

using Triple = std::array<double, 3>;

Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Triple cross_product(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// By curve, the edges in the order of the loop.
std::vector<std::vector<int>> edges_of_curves(const QuadMesh& mesh) {
  std::vector<std::vector<int>> edges(mesh.face.curves.size());
  for (int e = 0; e < static_cast<int>(mesh.boundary_edges.size()); ++e)
    edges[mesh.boundary_edges[e].curve].push_back(e);
  return edges;
}

int end_of_edge(const QuadMesh& mesh, int edge, bool is_last) {
  const QuadBoundaryEdge& e = mesh.boundary_edges[edge];
  return side_node(mesh, e.elem, e.side, is_last ? mesh.order : 0);
}

/// Whether the motion of a pair maps a node onto another one; on a curved face that of space.
class NodeImages {
 public:
  NodeImages(const QuadMesh& mesh, const PeriodicPair& pair) : mesh_(mesh), in_plane_(pair, mesh.face.origin) {
    if (mesh.face.chart) in_space_ = surface::periodic_motion(mesh.face, pair);
  }
  bool are_images(int from, int to) const {
    const double off = mesh_.face.chart
                           ? distance(surface::image(in_space_, mesh_.space_nodes[from]), mesh_.space_nodes[to])
                           : distance(in_plane_.image(mesh_.nodes[from]), mesh_.nodes[to]);
    return off <= tolerance::round_off * mesh_.face.diameter;
  }

 private:
  const QuadMesh& mesh_;
  PeriodicMotion in_plane_;
  SpaceMotion in_space_;
};

/// Vertices and edges that are one.
struct Identified {
  DisjointSets vertices, edges;
};

Identified identified(const QuadMesh& mesh, const EdgeNumbering& numbering, Motions motions) {
  Identified sets{DisjointSets(numbering.num_vertices()), DisjointSets(numbering.num_edges())};
  for (const PeriodicEdges& pair : periodic_edges(mesh)) {
    if (motions == Motions::translations && mesh.face.periodic_pairs[pair.pair].angle != 0) continue;
    const QuadBoundaryEdge &first = mesh.boundary_edges[pair.first], &second = mesh.boundary_edges[pair.second];
    const auto vertex = [&](const QuadBoundaryEdge& e, int end) {
      return numbering.elem2verts[4 * e.elem + (e.side + end) % 4];
    };
    const auto edge = [&](const QuadBoundaryEdge& e) { return numbering.elem2edges[4 * e.elem + e.side]; };
    sets.vertices.unite(vertex(first, 0), vertex(second, 1));
    sets.vertices.unite(vertex(first, 1), vertex(second, 0));
    sets.edges.unite(edge(first), edge(second));
  }
  return sets;
}

/// An edge whose two ends are also those of another edge, or one vertex; -1 if each edge is known by its ends.
int ambiguous_edge(const EdgeNumbering& numbering, Identified& sets) {
  std::vector<std::array<int, 3>> edges;  // ends, number
  for (int e = 0; e < numbering.num_edges(); ++e) {
    if (sets.edges.find(e) != e) continue;
    const auto [a, b] = numbering.edges[e].vertices;
    const auto [low, high] = std::minmax({sets.vertices.find(a), sets.vertices.find(b)});
    if (low == high) return e;
    edges.push_back({low, high, e});
  }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end(), [](const auto& one, const auto& other) {
    return one[0] == other[0] && one[1] == other[1];
  });
  return twice == edges.end() ? -1 : (*twice)[2];
}

}  // namespace

std::vector<PeriodicEdges> periodic_edges(const QuadMesh& mesh) {
  std::vector<PeriodicEdges> result;
  const std::vector<std::vector<int>> edges = edges_of_curves(mesh);
  for (int p = 0; p < static_cast<int>(mesh.face.periodic_pairs.size()); ++p) {
    const PeriodicPair& pair = mesh.face.periodic_pairs[p];
    const NodeImages images(mesh, pair);
    const std::vector<int>&firsts = edges[pair.curves[0]], &seconds = edges[pair.curves[1]];
    for (std::size_t k = 0; k < std::max(firsts.size(), seconds.size()); ++k) {
      const bool is_there = k < firsts.size() && k < seconds.size();
      const int first = k < firsts.size() ? firsts[k] : firsts.empty() ? seconds.front() : firsts.back();
      const int second = is_there ? seconds[seconds.size() - 1 - k] : -1;
      if (!is_there || !images.are_images(end_of_edge(mesh, first, false), end_of_edge(mesh, second, true)) ||
          !images.are_images(end_of_edge(mesh, first, true), end_of_edge(mesh, second, false)))
        throw ComputeError("no edge of the other periodic side is the image of the edge at " +
                           surface::position_text(mesh.face, mesh.nodes[end_of_edge(mesh, first, false)]) +
                           ": make the mesh again from the blocks (quadrefine)");
      result.push_back({first, second, p});
    }
  }
  return result;
}

std::array<double, 16> affine_motion(const SpaceMotion& motion) {
  const auto& [x, y, z] = motion.matrix;
  const Vec3 s = motion.shift;
  return {x.x, x.y, x.z, s.x, y.x, y.y, y.z, s.y, z.x, z.y, z.z, s.z, 0, 0, 0, 1};
}

// The frame's axes have one length and are normal to each other; what is normal to both stays.
std::array<double, 16> affine_motion(const CadFace& face, int pair, const Frame& frame) {
  if (face.chart) return affine_motion(surface::periodic_motion(face, face.periodic_pairs[pair]));
  const PeriodicMotion motion(face.periodic_pairs[pair], face.origin);
  const Triple& x = frame.x_axis;
  const Triple& y = frame.y_axis;
  const double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const Triple from = frame.at({0, 0}), to = frame.at(motion.image({0, 0}));
  const Triple image_x = minus(frame.at(motion.image({1, 0})), to), image_y = minus(frame.at(motion.image({0, 1})), to);
  const Triple normal = cross_product(x, y);
  std::array<double, 16> result{};
  for (int i = 0; i < 3; ++i) {
    double moved = 0;
    for (int j = 0; j < 3; ++j) {
      result[4 * i + j] = (image_x[i] * x[j] + image_y[i] * y[j]) / square + normal[i] * normal[j] / (square * square);
      moved += result[4 * i + j] * from[j];
    }
    result[4 * i + 3] = to[i] - moved;
  }
  result[15] = 1;
  return result;
}

std::vector<PeriodicPair> translated_pairs(const CadFace& face) {
  std::vector<PeriodicPair> pairs = face.periodic_pairs;
  std::erase_if(pairs, [](const PeriodicPair& pair) { return pair.angle != 0; });
  return pairs;
}

std::vector<PeriodicPair> rotated_pairs(const CadFace& face) {
  std::vector<PeriodicPair> pairs = face.periodic_pairs;
  std::erase_if(pairs, [](const PeriodicPair& pair) { return pair.angle == 0; });
  return pairs;
}

std::string periodic_names(const CadFace& face, const std::vector<PeriodicPair>& pairs) {
  std::set<std::pair<std::string, std::string>> names;
  for (const PeriodicPair& pair : pairs)
    names.emplace(face.curve_names[pair.curves[0]], face.curve_names[pair.curves[1]]);
  std::string list;
  for (const auto& [first, second] : names)
    list += fmt::format("{}\"{}\" and \"{}\"", list.empty() ? "" : "; ", first, second);
  return list;
}

std::string periodic_loss(const CadFace& face, const std::vector<PeriodicPair>& pairs, std::string_view why) {
  if (pairs.empty()) return {};
  return fmt::format("that sides are periodic is not stored, their nodes are images of each other: {}{}",
                     periodic_names(face, pairs), why.empty() ? "" : fmt::format(" ({})", why));
}

PeriodicVertices periodic_vertices(const QuadMesh& mesh, const EdgeNumbering& numbering, Motions motions,
                                   const char* reader) {
  const CadFace& face = mesh.face;
  const std::vector<PeriodicPair> pairs = motions == Motions::all ? face.periodic_pairs : translated_pairs(face);
  if (pairs.empty()) return {};
  Identified sets = identified(mesh, numbering, motions);
  PeriodicVertices result;
  if (const int edge = ambiguous_edge(numbering, sets); edge >= 0) {
    const std::vector<int> nodes = edge_nodes(mesh, numbering.edges[edge]);
    const auto position = [&](int node) { return position_text(mesh.nodes[node] + face.origin); };
    result.loss = periodic_loss(
        face, pairs,
        fmt::format("{} identifies edges by their ends, and the edge from {} to {} would have those of another one: "
                    "refine to at least three elements from side to side; sides that meet in a corner stay apart",
                    reader, position(nodes.front()), position(nodes.back())));
    return result;
  }
  for (int v = 0; v < numbering.num_vertices(); ++v) result.same.push_back(sets.vertices.find(v));
  return result;
}

}  // namespace quadrille::exports
