#include "triangulate/draft.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/tolerance.hpp"

namespace quadrille::triangulate {
namespace {

using Edge = std::pair<int, int>;

/// The corners of triangles (corner k of triangle t is 3 t + k) that lie in one sector of their vertex, between the
/// edges `closed`.
DisjointSets sectors_of(const Draft& draft, const std::set<Edge>& closed) {
  std::map<Edge, int> edge2corner;  ///< to the corner at which the edge of a triangle starts
  DisjointSets sectors(3 * draft.triangles.size());
  const int count = static_cast<int>(draft.triangles.size());
  for (int t = 0; t < count; ++t) {
    for (int k = 0; k < 3; ++k) {
      const int from = draft.triangles[t][k], to = draft.triangles[t][(k + 1) % 3];
      if (closed.contains({from, to})) continue;
      edge2corner[{from, to}] = 3 * t + k;
      const auto across = edge2corner.find({to, from});
      if (across == edge2corner.end()) continue;
      const int other = across->second;
      sectors.unite(3 * t + k, other - other % 3 + (other + 1) % 3);
      sectors.unite(3 * t + (k + 1) % 3, other);
    }
  }
  return sectors;
}

using Star = std::vector<int>;  ///< the triangles around a vertex

double least_shape(const Draft& draft, const Star& star) {
  double least = 1;
  for (const int t : star) {
    const auto& [a, b, c] = draft.triangles[t];
    least = std::min(least, triangle_shape(draft.vertices[a], draft.vertices[b], draft.vertices[c]));
  }
  return least;
}

Vec2 mean_of_neighbours(const Draft& draft, const Star& star, int vertex) {
  // Every neighbour of an inner vertex is in two triangles of its star.
  Vec2 sum;
  for (const int t : star)
    for (const int v : draft.triangles[t])
      if (v != vertex) sum += draft.vertices[v];
  return sum / (2 * static_cast<double>(star.size()));
}

void improve(Draft& draft, const Star& star, int vertex) {
  const Vec2 old = draft.vertices[vertex], goal = mean_of_neighbours(draft, star, vertex);
  double best = least_shape(draft, star);
  Vec2 best_position = old;
  for (const double step : {1.0, 0.5, 0.25}) {
    draft.vertices[vertex] = old + step * (goal - old);
    const double shape = least_shape(draft, star);
    if (shape > best + tolerance::round_off) best = shape, best_position = draft.vertices[vertex];
  }
  draft.vertices[vertex] = best_position;
}

// Of each vertex. Every connected part of the mesh has edges on the boundary of its region.
std::vector<int> regions_of_vertices(const TriMesh& mesh) {
  DisjointSets parts(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.elem2vertices) {
    parts.unite(a, b);
    parts.unite(b, c);
  }
  std::vector<int> region_of_part(mesh.vertices.size(), 0), regions;
  for (const BoundaryEdge& edge : mesh.boundary_edges)
    region_of_part[parts.find(mesh.elem2vertices[edge.elem].front())] =
        mesh.face.region_of_loop(mesh.face.loop_of(edge.curve));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    regions.push_back(region_of_part[parts.find(static_cast<int>(v))]);
  return regions;
}

// The numbers 0, 1, ... sorted by their regions.
std::vector<int> order_of(const std::vector<int>& regions) {
  std::vector<int> order(regions.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return regions[a] < regions[b]; });
  return order;
}

std::vector<int> inverse_of(const std::vector<int>& order) {
  std::vector<int> inverse(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) inverse[order[i]] = static_cast<int>(i);
  return inverse;
}

template <typename T>
void permute(std::vector<T>& values, const std::vector<int>& order) {
  const std::vector<T> before = values;
  for (std::size_t i = 0; i < order.size(); ++i) values[i] = before[order[i]];
}

}  // namespace

std::vector<int> cut_slits(Draft& draft) {
  std::vector<int> origins(draft.vertices.size());
  std::iota(origins.begin(), origins.end(), 0);
  std::set<Edge> closed;
  std::vector<int> num_sectors(draft.vertices.size(), 0);
  for (const DraftEdge& edge : draft.edges) closed.insert({edge.from, edge.to}), ++num_sectors[edge.from];
  if (std::all_of(num_sectors.begin(), num_sectors.end(), [](int num) { return num < 2; })) return origins;
  DisjointSets sectors = sectors_of(draft, closed);
  std::map<Edge, int> vertices;  ///< (vertex, sector) to the vertex or its copy
  std::set<int> seen;
  std::vector<std::array<int, 3>> triangles = draft.triangles;
  std::map<Edge, Edge> edges;  ///< of the triangles: old to new vertices
  // Copies in the order of their vertices, then of their triangles: independent of the order of the sectors.
  std::vector<std::pair<int, int>> corners;
  for (int c = 0; c < 3 * static_cast<int>(triangles.size()); ++c) corners.emplace_back(triangles[c / 3][c % 3], c);
  std::sort(corners.begin(), corners.end());
  for (const auto& [vertex, corner] : corners) {
    const auto [found, is_new] = vertices.try_emplace({vertex, sectors.find(corner)}, vertex);
    if (is_new && !seen.insert(vertex).second) {
      found->second = draft.add_vertex(draft.vertices[vertex]);
      origins.push_back(vertex);
    }
    draft.triangles[corner / 3][corner % 3] = found->second;
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      edges[{triangles[t][k], triangles[t][(k + 1) % 3]}] = {draft.triangles[t][k], draft.triangles[t][(k + 1) % 3]};
  for (DraftEdge& edge : draft.edges) std::tie(edge.from, edge.to) = edges.at({edge.from, edge.to});
  return origins;
}

double triangle_shape(Vec2 a, Vec2 b, Vec2 c) {
  return 2 * std::sqrt(3.0) * cross(b - a, c - a) / (norm2(b - a) + norm2(c - b) + norm2(a - c));
}

void smooth(Draft& draft, const std::vector<char>& is_free) {
  constexpr int num_sweeps = 6;
  std::vector<Star> stars(draft.vertices.size());
  for (int t = 0; t < static_cast<int>(draft.triangles.size()); ++t)
    for (const int v : draft.triangles[t]) stars[v].push_back(t);
  for (int sweep = 0; sweep < num_sweeps; ++sweep)
    for (int v = 0; v < static_cast<int>(draft.vertices.size()); ++v)
      if (is_free[v]) improve(draft, stars[v], v);
}

std::vector<int> sort_by_region(TriMesh& mesh) {
  std::vector<int> vertices(mesh.vertices.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  if (mesh.face.num_regions() == 1) return vertices;
  const std::vector<int> regions = regions_of_vertices(mesh);
  std::vector<int> region_of_elem;
  for (const auto& triangle : mesh.elem2vertices) region_of_elem.push_back(regions[triangle.front()]);
  vertices = order_of(regions);
  const std::vector<int> elems = order_of(region_of_elem), new_vertices = inverse_of(vertices),
                         new_elems = inverse_of(elems);
  permute(mesh.vertices, vertices);
  permute(mesh.elem2vertices, elems);
  permute(mesh.elem_layer, elems);
  for (auto& triangle : mesh.elem2vertices)
    for (int& v : triangle) v = new_vertices[v];
  for (BoundaryEdge& edge : mesh.boundary_edges) edge.elem = new_elems[edge.elem];
  mesh.region_elems.assign(mesh.face.num_regions() + 1, 0);
  for (const int r : region_of_elem) ++mesh.region_elems[r + 1];
  std::partial_sum(mesh.region_elems.begin(), mesh.region_elems.end(), mesh.region_elems.begin());
  return vertices;
}

}  // namespace quadrille::triangulate
