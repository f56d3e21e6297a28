#include "refine/tip_rings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "curve/face_boundary.hpp"
#include "mesh/transfinite.hpp"
#include "refine/tip_patch.hpp"
#include "refine/tip_rounding.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

/// A vertex of the mesh, on its ray from the tip at 2^-level of its distance.
struct RingVertex {
  int vertex = 0, level = 0;
  auto operator<=>(const RingVertex&) const = default;
};

class RingBuilder {
 public:
  RingBuilder(const QuadMesh& mesh, int tip, int num_rings)
      : mesh_(mesh), boundary_(mesh.face), tip_(tip), num_rings_(num_rings), origin_(mesh.nodes[tip]) {}

  void build(const std::vector<TipPatch>& patches, const std::map<QuadSide, int>& curves) {
    for (const TipPatch& patch : patches) {
      note_walls(patch, curves);
      keep_outer_edges(patch);
    }
    std::set<int> fixed;
    for (const QuadBoundaryEdge& e : mesh_.boundary_edges) fixed.insert(side_start(mesh_, e.elem, e.side));
    for (const TipPatch& patch : patches) round_outer_vertices(patch, fixed, mesh_);
    for (const TipPatch& patch : patches) {
      add_rings(patch);
      shrink(patch);
    }
    drop_unused_nodes();
    count_irregular();
  }
  QuadMesh mesh() && { return std::move(mesh_); }

 private:
  void note_walls(const TipPatch& patch, const std::map<QuadSide, int>& curves) {
    for (const bool is_at_start : {true, false}) {
      const auto at = curves.find(patch.wall_edge(is_at_start, 0));
      for (int k = 1; k <= patch.width() && at != curves.end(); ++k)
        walls_[is_at_start ? patch.vertex(k, 0) : patch.vertex(0, k)] = at->second;
    }
  }

  /// Nodes between two vertices in the direction from the lesser one; those of outer edges exist.
  void keep_outer_edges(const TipPatch& patch) {
    for (int k = 0; k < 2 * patch.width(); ++k) {
      const auto [elem, side] = patch.outer_edge(k);
      std::vector<int> nodes = side_nodes(mesh_, elem, side);
      if (nodes.front() > nodes.back()) std::ranges::reverse(nodes);
      edges_[{{nodes.front(), 0}, {nodes.back(), 0}}] = {nodes.begin() + 1, nodes.end() - 1};
    }
  }

  void add_rings(const TipPatch& patch) {
    const int count = 2 * patch.width();
    for (int k = 0; k < count; ++k) {
      const int from = patch.outer_vertex(k), to = patch.outer_vertex(k + 1), first = mesh_.num_elems();
      for (int level = 1; level <= num_rings_; ++level) {
        const int elem = append_element(mesh_.elem_block[patch.outer_edge(k).first]);
        place(elem, 0, {{{from, level}, {from, level - 1}, {to, level - 1}, {to, level}}});
      }
      if (k == 0) add_wall_edges(patch, true, first);
      if (k == count - 1) add_wall_edges(patch, false, first);
    }
  }

  int append_element(int block) {
    mesh_.elem_block.push_back(block);
    mesh_.elem_nodes.resize(mesh_.elem_nodes.size() + mesh_.nodes_per_elem());
    if (!mesh_.elem_prescribed_length.empty()) mesh_.elem_prescribed_length.push_back(0);
    if (!mesh_.elem_prescribed_stretch.empty()) mesh_.elem_prescribed_stretch.emplace_back();
    return mesh_.num_elems() - 1;
  }

  /// The boundary edges of the rings, of which `first` is outermost, beside that of the patch.
  void add_wall_edges(const TipPatch& patch, bool is_at_start, int first) {
    const QuadSide last = patch.wall_edge(is_at_start, patch.width() - 1);
    const auto at = std::ranges::find_if(mesh_.boundary_edges, [&](const QuadBoundaryEdge& e) {
      return QuadSide{e.elem, e.side} == last;
    });
    if (at == mesh_.boundary_edges.end()) return;
    std::vector<QuadBoundaryEdge> edges;
    for (int ring = 0; ring < num_rings_; ++ring) edges.push_back({first + ring, is_at_start ? 0 : 2, at->curve});
    if (is_at_start) std::ranges::reverse(edges);
    mesh_.boundary_edges.insert(is_at_start ? at + 1 : at, edges.begin(), edges.end());
  }

  /// The elements of the patch become those inside the rings.
  void shrink(const TipPatch& patch) {
    const auto vertex = [&](int i, int j) { return RingVertex{patch.vertex(i, j), i + j == 0 ? 0 : num_rings_}; };
    std::vector<std::array<RingVertex, 4>> corners;
    for (int j = 0; j < patch.width(); ++j)
      for (int i = 0; i < patch.width(); ++i)
        corners.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const TipPatch::Cell& cell = patch.cell(static_cast<int>(k) % patch.width(), static_cast<int>(k) / patch.width());
      place(cell.elem, cell.corner, corners[k]);
      if (!mesh_.elem_prescribed_length.empty()) mesh_.elem_prescribed_length[cell.elem] = 0;
    }
  }

  int node_at(int elem, int i, int j) const {
    return mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + j * (mesh_.order + 1) + i];
  }

  /// Sets the nodes of an element with these corners, of which the first one is its corner number `first`.
  void place(int elem, int first, const std::array<RingVertex, 4>& corners) {
    const int n = mesh_.order;
    int* const ids = &mesh_.elem_nodes[elem * mesh_.nodes_per_elem()];
    for (int k = 0; k < 4; ++k) {
      const std::vector<int> nodes = edge_nodes(corners[k], corners[(k + 1) % 4]);
      for (int i = 0; i <= n; ++i) ids[local_side_node(n, (first + k) % 4, i)] = nodes[i];
    }
    const auto at = [&](int i, int j) { return mesh_.nodes[ids[j * (n + 1) + i]]; };
    const std::array<Vec2, 4> ends{at(0, 0), at(n, 0), at(n, n), at(0, n)};
    const std::vector<double>& xi = spectral::gll_points(n);
    for (int j = 1; j < n; ++j)
      for (int i = 1; i < n; ++i) {
        const Vec2 x =
            mesh::blend_sides({at(i, 0), at(n, j), at(i, n), at(0, j)}, ends, (1 + xi[i]) / 2, (1 + xi[j]) / 2);
        ids[j * (n + 1) + i] = append_node(x, -1);
      }
  }

  /// On a curve of the boundary if that is one.
  int append_node(Vec2 x, int curve) {
    if (curve >= 0) x = boundary_.nearest(x, [&](int c) { return c == curve; }).position;
    mesh_.nodes.push_back(x);
    return static_cast<int>(mesh_.nodes.size()) - 1;
  }

  int wall_of(int vertex) const {
    const auto at = walls_.find(vertex);
    return at == walls_.end() ? -1 : at->second;
  }

  int node_of(RingVertex v) {
    if (v.level == 0) return v.vertex;
    const auto [at, is_new] = vertices_.try_emplace(v, 0);
    const Vec2 away = mesh_.nodes[v.vertex] - origin_;
    if (is_new) at->second = append_node(origin_ + std::ldexp(1.0, -v.level) * away, wall_of(v.vertex));
    return at->second;
  }

  /// Straight but on the boundary, and where the edge exists.
  std::vector<int> edge_nodes(RingVertex from, RingVertex to) {
    const bool is_backwards = to < from;
    if (is_backwards) std::swap(from, to);
    const int a = node_of(from), b = node_of(to);
    const auto [at, is_new] = edges_.try_emplace({from, to});
    if (is_new) {
      const int of_a = a == tip_ ? wall_of(to.vertex) : wall_of(from.vertex);
      const int of_b = b == tip_ ? of_a : wall_of(to.vertex);
      for (int k = 1; k < mesh_.order; ++k) {
        const double s = (1 + spectral::gll_points(mesh_.order)[k]) / 2;
        at->second.push_back(append_node((1 - s) * mesh_.nodes[a] + s * mesh_.nodes[b], of_a == of_b ? of_a : -1));
      }
    }
    std::vector<int> nodes{a};
    nodes.insert(nodes.end(), at->second.begin(), at->second.end());
    nodes.push_back(b);
    if (is_backwards) std::ranges::reverse(nodes);
    return nodes;
  }

  void drop_unused_nodes() {
    std::vector<int> number(mesh_.nodes.size(), -1);
    for (const int node : mesh_.elem_nodes) number[node] = 0;
    int count = 0;
    for (std::size_t node = 0; node < number.size(); ++node) {
      if (number[node] < 0) continue;
      mesh_.nodes[count] = mesh_.nodes[node];
      number[node] = count++;
    }
    mesh_.nodes.resize(count);
    for (int& node : mesh_.elem_nodes) node = number[node];
  }

  void count_irregular() {
    std::map<int, int> valence;
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (int k = 0; k < 4; ++k) ++valence[side_start(mesh_, elem, k)];
    for (const QuadBoundaryEdge& e : mesh_.boundary_edges) valence.erase(side_start(mesh_, e.elem, e.side));
    mesh_.num_irregular =
        static_cast<int>(std::ranges::count_if(valence, [](const auto& of) { return of.second != 4; }));
  }

  QuadMesh mesh_;
  curve::FaceBoundary boundary_;
  int tip_, num_rings_;
  Vec2 origin_;
  std::map<int, int> walls_;  ///< the curve of a vertex on the boundary
  std::map<RingVertex, int> vertices_;
  std::map<std::pair<RingVertex, RingVertex>, std::vector<int>> edges_;
};

}  // namespace

std::optional<QuadMesh> with_tip_rings(const QuadMesh& mesh, int tip, TipRings rings) {
  std::map<QuadSide, int> curves;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges) curves[{e.elem, e.side}] = e.curve;
  const std::vector<TipPatch> patches = tip_patches(mesh, tip, rings.width, curves);
  if (patches.empty()) return std::nullopt;
  RingBuilder builder(mesh, tip, rings.num_rings);
  builder.build(patches, curves);
  return std::move(builder).mesh();
}

}  // namespace quadrille::refine
