#include "refine/tip_rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/tolerance.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

constexpr int num_steps = 8;  ///< of the way to the circle that are tried

double least_sine(const std::array<Vec2, 4>& corners) {
  double least = 1;
  for (int k = 0; k < 4; ++k) {
    const Vec2 ahead = corners[(k + 1) % 4] - corners[k], back = corners[(k + 3) % 4] - corners[k];
    least = std::min(least, cross(ahead, back) / (norm(ahead) * norm(back)));
  }
  return least;
}

class OuterVertices {
 public:
  OuterVertices(const TipPatch& patch, const std::set<int>& fixed, QuadMesh& mesh)
      : patch_(patch), mesh_(mesh), tip_(mesh.nodes[patch.vertex(0, 0)]) {
    const int last = 2 * patch.width();
    const auto radius = [&](int k) { return distance(mesh.nodes[patch.outer_vertex(k)], tip_); };
    for (int k = 1; k < last; ++k) {
      const int vertex = patch.outer_vertex(k);
      if (fixed.contains(vertex)) continue;
      const double circle = radius(0) + (radius(last) - radius(0)) * k / last;
      start_[vertex] = mesh.nodes[vertex];
      way_[vertex] = (circle / radius(k) - 1) * (mesh.nodes[vertex] - tip_);
    }
  }

  void round() {
    double best = -HUGE_VAL, best_part = 0;
    for (int step = 0; step <= num_steps; ++step) {
      const double part = static_cast<double>(step) / num_steps;
      const double sine = least_sine_at(part);
      if (sine > best + tolerance::tied) best = sine, best_part = part;
    }
    for (const auto& [vertex, way] : way_) move(vertex, best_part * way);
  }

 private:
  Vec2 position(int vertex, double part) const {
    return start_.contains(vertex) ? start_.at(vertex) + part * way_.at(vertex) : mesh_.nodes[vertex];
  }

  /// Of the angles of elements at these vertices and of the outermost ring, all with straight sides, after this part
  /// of the way.
  double least_sine_at(double part) const {
    double least = 1;
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      std::array<int, 4> corners;
      for (int k = 0; k < 4; ++k) corners[k] = side_start(mesh_, elem, k);
      if (std::ranges::none_of(corners, [&](int v) { return start_.contains(v); })) continue;
      const auto at = [&](int k) { return position(corners[k], part); };
      least = std::min(least, least_sine({at(0), at(1), at(2), at(3)}));
    }
    for (int k = 0; k < 2 * patch_.width(); ++k) {
      const Vec2 from = position(patch_.outer_vertex(k), part), to = position(patch_.outer_vertex(k + 1), part);
      least = std::min(least, least_sine({(from + tip_) / 2, from, to, (to + tip_) / 2}));
    }
    return least;
  }

  /// With the nodes of its elements, less with their distance from it.
  void move(int vertex, Vec2 by) {
    const int n = mesh_.order;
    const std::vector<double>& xi = spectral::gll_points(n);
    std::map<int, double> parts;
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (int corner = 0; corner < 4; ++corner) {
        if (side_start(mesh_, elem, corner) != vertex) continue;
        const double x = corner == 1 || corner == 2 ? 1 : -1, y = corner >= 2 ? 1 : -1;
        for (int j = 0; j <= n; ++j)
          for (int i = 0; i <= n; ++i)
            parts[mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + j * (n + 1) + i]] =
                (1 + x * xi[i]) * (1 + y * xi[j]) / 4;
      }
    for (const auto& [node, part] : parts) mesh_.nodes[node] += part * by;
  }

  const TipPatch& patch_;
  QuadMesh& mesh_;
  Vec2 tip_;
  std::map<int, Vec2> start_, way_;  ///< of the vertices that move
};

}  // namespace

void round_outer_vertices(const TipPatch& patch, const std::set<int>& fixed, QuadMesh& mesh) {
  OuterVertices(patch, fixed, mesh).round();
}

}  // namespace quadrille::refine
