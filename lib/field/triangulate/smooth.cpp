#include "triangulate/smooth.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille::triangulate {
namespace {

constexpr int num_sweeps = 6;
constexpr double least_gain = 1e-9;

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
      if (shape > best + least_gain) best = shape, best_position = draft_->vertices[vertex];
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
