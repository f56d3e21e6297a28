#include "space/improve_triangles.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "base/vec3.hpp"
#include "space/surface_triangles.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::space {

namespace {

constexpr double bad_shape = 0.05;   // of 1, that of an equilateral triangle
constexpr double least_gain = 1e-6;  // of a shape, so that rounding errors swap nothing
constexpr double most_off = 1e-3;    // of the size of the face: the distance of a side from the surface
constexpr int most_passes = 20;
constexpr std::size_t most_triangles = 40000;

class Improver : public SurfaceTriangles {
 public:
  using SurfaceTriangles::SurfaceTriangles;

  void improve() {
    reshape();
    split_where([&](int t) { return is_off(triangles_[t]); });
    reshape();
    split_where([&](int t) { return shapes_[t] < bad_shape; });
    reshape();
  }

 private:
  void swap_until_stable() {
    for (int pass = 0; pass < most_passes && swap_diagonals(); ++pass) continue;
  }

  void reshape() {
    swap_until_stable();
    for (int pass = 0; pass < most_passes && remove_vertices(); ++pass) swap_until_stable();
  }

  bool swap_diagonals() {
    bool has_swapped = false;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
      for (int k = 0; k < 3 && triangles_[t][0].vertex >= 0; ++k) has_swapped |= swap_if_better(t, k);
    return has_swapped;
  }

  /// The side from corner k to the next one, a b, becomes c d.
  bool swap_if_better(int t, int k) {
    const SurfaceCorner a = triangles_[t][k], b = triangles_[t][(k + 1) % 3], c = triangles_[t][(k + 2) % 3];
    const std::vector<int> both = triangles_with(a.vertex, b.vertex);
    if (both.size() != 2) return false;
    const int s = both[0] == t ? both[1] : both[0], at_b = position(s, b.vertex);
    SurfaceCorner d = triangles_[s][(at_b + 2) % 3];
    if (d.vertex == c.vertex || !triangles_with(c.vertex, d.vertex).empty()) return false;
    d.uv += whole_periods(b.uv - triangles_[s][at_b].uv);
    Triangle one{a, d, c}, other{d, b, c};
    set_poles(one), set_poles(other);
    const double before = std::min(shapes_[t], shapes_[s]);
    if (std::min(checked_shape(one), checked_shape(other)) < before + least_gain) return false;
    replace(t, one), replace(s, other);
    return true;
  }

  /// Splits triangles by their longest sides, until none of them has the fault.
  void split_where(const std::function<bool(int)>& has_fault) {
    bool has_split = true;
    for (int pass = 0; pass < most_passes && has_split && triangles_.size() < most_triangles; ++pass) {
      has_split = false;
      const int num_triangles = static_cast<int>(triangles_.size());  // new ones wait for the next pass
      for (int t = 0; t < num_triangles; ++t)
        if (triangles_[t][0].vertex >= 0 && has_fault(t)) split_side(t, longest_side(t)), has_split = true;
      swap_until_stable();
    }
  }

  /// Whether the middle of a side lies off the surface.
  bool is_off(const Triangle& t) const {
    for (int k = 0; k < 3; ++k) {
      const SurfaceCorner &a = t[k], &b = t[(k + 1) % 3];
      const Vec3 chord = (raw_.vertices[a.vertex] + raw_.vertices[b.vertex]) / 2.0;
      if (distance(surface::point(raw_.surface, middle(a, b)), chord) > most_off * size_) return true;
    }
    return false;
  }

  /// The side from corner k to the next one.
  void split_side(int t, int k) {
    const SurfaceCorner a = triangles_[t][k], b = triangles_[t][(k + 1) % 3], c = triangles_[t][(k + 2) % 3];
    const std::vector<int> both = triangles_with(a.vertex, b.vertex);
    const bool is_boundary = both.size() == 1;
    const SurfaceCorner m =
        is_boundary
            ? split_edge(a, b)
            : SurfaceCorner{new_vertex(surface::point(raw_.surface, middle(a, b)), middle(a, b), false), middle(a, b)};
    replace(t, {a, m, c}), add({m, b, c});
    if (is_boundary) return;
    const int s = both[0] == t ? both[1] : both[0], at_b = position(s, b.vertex);
    const SurfaceCorner other_b = triangles_[s][at_b], other_a = triangles_[s][(at_b + 1) % 3],
                        d = triangles_[s][(at_b + 2) % 3];
    const SurfaceCorner other_m{m.vertex, middle(other_a, other_b)};
    replace(s, {other_b, other_m, d}), add({other_m, other_a, d});
  }

  /// In the middle of the parameters of its curve.
  SurfaceCorner split_edge(const SurfaceCorner& a, const SurfaceCorner& b) {
    for (EdgePolygon& polygon : raw_.polygons)
      for (std::size_t i = 0; i + 1 < polygon.vertices.size(); ++i) {
        const std::pair side{polygon.vertices[i], polygon.vertices[i + 1]};
        if (side != std::pair{a.vertex, b.vertex} && side != std::pair{b.vertex, a.vertex}) continue;
        const double t = (polygon.parameters[i] + polygon.parameters[i + 1]) / 2;
        const auto at = surface::project(raw_.surface, surface::point(raw_.curves[polygon.edge], t), middle(a, b));
        const int m = new_vertex(at.position, at.uv, true);
        polygon.vertices.insert(polygon.vertices.begin() + static_cast<long>(i) + 1, m);
        polygon.parameters.insert(polygon.parameters.begin() + static_cast<long>(i) + 1, t);
        return {m, at.uv + whole_periods(middle(a, b) - at.uv)};
      }
    return {new_vertex(surface::point(raw_.surface, middle(a, b)), middle(a, b), true), middle(a, b)};
  }

  bool remove_vertices() {
    bool has_removed = false;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
      for (int k = 0; k < 3 && shapes_[t] < bad_shape; ++k)
        if (const int v = triangles_[t][k].vertex; !is_fixed_[v]) has_removed |= remove_vertex(v);
    return has_removed;
  }

  /// The triangles around v if it moves to its neighbour w; none if that is not possible.
  std::vector<std::pair<int, Triangle>> moved(int v, int w) const {
    const std::vector<int> both = triangles_with(v, w);
    if (both.size() != 2) return {};
    const std::set<int> of_v = neighbours(v), of_w = neighbours(w);
    if (std::count_if(of_v.begin(), of_v.end(), [&](int n) { return of_w.contains(n); }) != 2) return {};
    const Triangle& known = triangles_[both.front()];
    const Vec2 v_uv = known[position(both.front(), v)].uv, w_uv = known[position(both.front(), w)].uv;
    std::vector<std::pair<int, Triangle>> result;
    for (const int t : around_[v]) {
      if (position(t, w) >= 0) continue;
      Triangle triangle = triangles_[t];
      SurfaceCorner& corner = triangle[position(t, v)];
      corner = {w, w_uv + whole_periods(corner.uv - v_uv)};
      set_poles(triangle);
      result.emplace_back(t, triangle);
    }
    return result;
  }

  /// To the neighbour with which the worst triangle is best.
  bool remove_vertex(int v) {
    double best = 1;
    for (const int t : around_[v]) best = std::min(best, shapes_[t]);
    best += least_gain;
    std::vector<std::pair<int, Triangle>> chosen;
    int target = -1;
    for (const int w : neighbours(v)) {
      if (is_pole(w)) continue;
      auto triangles = moved(v, w);
      double worst = 1;
      for (const auto& [t, triangle] : triangles) worst = std::min(worst, checked_shape(triangle));
      if (!triangles.empty() && worst > best) best = worst, chosen = std::move(triangles), target = w;
    }
    if (target < 0) return false;
    for (const int t : triangles_with(v, target)) remove(t);
    for (const auto& [t, triangle] : chosen) replace(t, triangle);
    return true;
  }
};

}  // namespace

void improve_triangles(RawSpaceFace& raw) {
  Improver improver(raw);
  improver.improve();
  improver.store();
}

}  // namespace quadrille::space
