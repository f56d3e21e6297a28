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

bool has_slits(const Draft& draft) {
  std::set<Edge> edges;
  for (const DraftEdge& edge : draft.edges) edges.insert({edge.from, edge.to});
  return std::any_of(draft.edges.begin(), draft.edges.end(), [&](const DraftEdge& edge) {
    return edges.contains({edge.to, edge.from});
  });
}

/// The corners of triangles (corner k of triangle t is 3 t + k) that lie in one sector of their vertex.
DisjointSets sectors_of(const Draft& draft) {
  std::set<Edge> closed;
  for (const DraftEdge& edge : draft.edges) closed.insert({edge.from, edge.to});
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

constexpr int num_sweeps = 6;

using Triangle = std::array<int, 3>;

/// The triangles around each free vertex: offsets and values.
struct Stars {
  std::vector<int> offsets, values;
};

Stars stars_of(const Draft& draft, const std::vector<char>& is_free) {
  Stars stars;
  stars.offsets.assign(draft.vertices.size() + 1, 0);
  for (const Triangle& triangle : draft.triangles)
    for (const int v : triangle) stars.offsets[v + 1] += is_free[v];
  for (std::size_t v = 0; v < draft.vertices.size(); ++v) stars.offsets[v + 1] += stars.offsets[v];
  stars.values.resize(stars.offsets.back());
  std::vector<int> next = stars.offsets;
  for (int t = 0; t < static_cast<int>(draft.triangles.size()); ++t)
    for (const int v : draft.triangles[t])
      if (is_free[v]) stars.values[next[v]++] = t;
  return stars;
}

class Mover {
 public:
  Mover(Draft& draft, const std::vector<char>& is_free) : draft_(&draft), stars_(stars_of(draft, is_free)) {}

  void improve(int vertex) {
    const Vec2 old = draft_->vertices[vertex], goal = mean_of_neighbours(vertex);
    double best = least_shape(vertex);
    Vec2 best_position = old;
    for (const double step : {1.0, 0.5, 0.25}) {
      draft_->vertices[vertex] = old + step * (goal - old);
      const double shape = least_shape(vertex);
      if (shape > best + tolerance::round_off) best = shape, best_position = draft_->vertices[vertex];
    }
    draft_->vertices[vertex] = best_position;
  }

 private:
  Vec2 mean_of_neighbours(int vertex) const {
    // Every neighbour of an inner vertex is in two triangles of its star.
    Vec2 sum;
    int count = 0;
    for (int i = stars_.offsets[vertex]; i < stars_.offsets[vertex + 1]; ++i) {
      for (const int v : draft_->triangles[stars_.values[i]]) {
        if (v == vertex) continue;
        sum += draft_->vertices[v];
        ++count;
      }
    }
    return sum / count;
  }

  double least_shape(int vertex) const {
    double least = 1;
    for (int i = stars_.offsets[vertex]; i < stars_.offsets[vertex + 1]; ++i) {
      const auto& [a, b, c] = draft_->triangles[stars_.values[i]];
      least = std::min(least, triangle_shape(draft_->vertices[a], draft_->vertices[b], draft_->vertices[c]));
    }
    return least;
  }

  Draft* draft_;
  Stars stars_;
};

}  // namespace

std::vector<int> cut_slits(Draft& draft) {
  std::vector<int> origins(draft.vertices.size());
  std::iota(origins.begin(), origins.end(), 0);
  if (!has_slits(draft)) return origins;
  DisjointSets sectors = sectors_of(draft);
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
  Mover mover(draft, is_free);
  for (int sweep = 0; sweep < num_sweeps; ++sweep)
    for (int v = 0; v < static_cast<int>(draft.vertices.size()); ++v)
      if (is_free[v]) mover.improve(v);
}

}  // namespace quadrille::triangulate
