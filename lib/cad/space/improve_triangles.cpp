#include "space/improve_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "base/vec3.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::space {

namespace {

constexpr double bad_shape = 0.05;   // of 1, that of an equilateral triangle
constexpr double least_gain = 1e-6;  // of a shape, so that rounding errors swap nothing
constexpr double most_off = 1e-3;    // of the size of the face: the distance of a side from the surface
constexpr int most_passes = 20;
constexpr std::size_t most_triangles = 40000;

struct Corner {
  int vertex = 0;
  Vec2 uv;
};
using Triangle = std::array<Corner, 3>;

/// Whole periods nearest to the difference of two parameters.
Vec2 whole_periods(const NurbsSurface& s, Vec2 difference) {
  const double u = s.knots_u.back() - s.knots_u.front(), v = s.knots_v.back() - s.knots_v.front();
  return {s.is_closed_u ? u * std::round(difference.x / u) : 0, s.is_closed_v ? v * std::round(difference.y / v) : 0};
}

class Improver {
 public:
  explicit Improver(RawSpaceFace& raw)
      : raw_(raw), around_(raw.vertices.size()), is_fixed_(raw.vertices.size(), false) {
    for (std::size_t t = 0; t < raw.triangles.size(); ++t) {
      Triangle triangle{};
      for (int k = 0; k < 3; ++k) triangle[k] = {raw.triangles[t][k], raw.triangle_uv[t][k]};
      for (const Corner& c : triangle) around_[c.vertex].push_back(static_cast<int>(t));
      triangles_.push_back(triangle);
    }
    for (const Vec3& x : raw.vertices) size_ = std::max(size_, distance(x, raw.vertices.front()));
    least_area_ = 1e-12 * (raw.surface.knots_u.back() - raw.surface.knots_u.front()) *
                  (raw.surface.knots_v.back() - raw.surface.knots_v.front());
    fix_vertices();
    for (Triangle& t : triangles_) set_poles(t), shapes_.push_back(shape(t));
  }

  void improve() {
    reshape();
    split_where([&](int t) { return is_off(triangles_[t]); });
    reshape();
    split_where([&](int t) { return shapes_[t] < bad_shape; });
    reshape();
  }

  /// Without the triangles and vertices that were removed.
  void store() {
    std::vector<int> number(raw_.vertices.size(), -1);
    std::vector<Vec3> vertices;
    for (std::size_t v = 0; v < number.size(); ++v)
      if (!around_[v].empty()) number[v] = static_cast<int>(vertices.size()), vertices.push_back(raw_.vertices[v]);
    raw_.vertices = std::move(vertices);
    raw_.triangles.clear(), raw_.triangle_uv.clear();
    for (const Triangle& t : triangles_) {
      if (t[0].vertex < 0) continue;
      raw_.triangles.push_back({number[t[0].vertex], number[t[1].vertex], number[t[2].vertex]});
      raw_.triangle_uv.push_back({t[0].uv, t[1].uv, t[2].uv});
    }
    for (EdgePolygon& polygon : raw_.polygons)
      for (int& v : polygon.vertices) v = number[v];
  }

 private:
  /// Unit normal of the face; zero at a pole.
  Vec3 normal(Vec2 uv) const {
    const auto p = surface::evaluate(raw_.surface, uv);
    const double xu = norm(p.xu), xv = norm(p.xv);
    if (std::min(xu, xv) <= 1e-9 * std::max(xu, xv)) return {};
    return (raw_.is_reversed ? -1.0 : 1.0) * normalized(cross(p.xu, p.xv));
  }

  /// 1 for an equilateral triangle, 0 for one without area, negative if it is seen from behind.
  double shape(const Triangle& t) const {
    const Vec3 &a = raw_.vertices[t[0].vertex], &b = raw_.vertices[t[1].vertex], &c = raw_.vertices[t[2].vertex];
    const Vec3 along = normals_[t[0].vertex] + normals_[t[1].vertex] + normals_[t[2].vertex];
    const double twice_area = dot(cross(b - a, c - a), along) / norm(along);
    return 2 * std::sqrt(3.0) * twice_area / (norm2(b - a) + norm2(c - b) + norm2(a - c));
  }

  /// Of a new triangle, which must be counter-clockwise in the parameters: so triangles that the kernel made too
  /// coarse, and that look turned over in space, are right when they are finer.
  double checked_shape(const Triangle& t) const {
    const double area = cross(t[1].uv - t[0].uv, t[2].uv - t[0].uv) * (raw_.is_reversed ? -1 : 1);
    return area > least_area_ ? shape(t) : -1;
  }

  /// Those on edges of the file, and poles.
  void fix_vertices() {
    for (const EdgePolygon& polygon : raw_.polygons)
      for (const int v : polygon.vertices) is_fixed_[v] = true;
    for (const Triangle& t : triangles_)
      for (const Corner& c : t) {
        const auto p = surface::evaluate(raw_.surface, c.uv);
        const double xu = norm(p.xu), xv = norm(p.xv), least = 1e-9 * std::max(xu, xv);
        if (xu <= least) free_[c.vertex] = &Vec2::x;
        if (xv <= least) free_[c.vertex] = &Vec2::y;
        if (is_pole(c.vertex)) is_fixed_[c.vertex] = true;
        normals_[c.vertex] = normal(c.uv);
      }
  }

  bool is_pole(int v) const { return free_[v] != nullptr; }

  /// At a pole, one parameter says nothing: it is that of the middle of the other corners.
  void set_poles(Triangle& t) const {
    for (int k = 0; k < 3; ++k)
      if (const auto free = free_[t[k].vertex]) t[k].uv.*free = (t[(k + 1) % 3].uv.*free + t[(k + 2) % 3].uv.*free) / 2;
  }

  int position(int t, int vertex) const {
    for (int k = 0; k < 3; ++k)
      if (triangles_[t][k].vertex == vertex) return k;
    return -1;
  }

  std::vector<int> triangles_with(int a, int b) const {
    std::vector<int> found;
    for (const int t : around_[a])
      if (position(t, b) >= 0) found.push_back(t);
    return found;
  }

  void replace(int t, const Triangle& triangle) {
    for (const Corner& c : triangles_[t]) std::erase(around_[c.vertex], t);
    for (const Corner& c : triangle) around_[c.vertex].push_back(t);
    triangles_[t] = triangle;
    set_poles(triangles_[t]);
    shapes_[t] = shape(triangles_[t]);
  }

  void add(const Triangle& triangle) {
    for (const Corner& c : triangle) around_[c.vertex].push_back(static_cast<int>(triangles_.size()));
    triangles_.push_back(triangle);
    set_poles(triangles_.back());
    shapes_.push_back(shape(triangles_.back()));
  }

  void remove(int t) {
    for (const Corner& c : triangles_[t]) std::erase(around_[c.vertex], t);
    triangles_[t][0].vertex = -1, shapes_[t] = 1;
  }

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
    const Corner a = triangles_[t][k], b = triangles_[t][(k + 1) % 3], c = triangles_[t][(k + 2) % 3];
    const std::vector<int> both = triangles_with(a.vertex, b.vertex);
    if (both.size() != 2) return false;
    const int s = both[0] == t ? both[1] : both[0], at_b = position(s, b.vertex);
    Corner d = triangles_[s][(at_b + 2) % 3];
    if (d.vertex == c.vertex || !triangles_with(c.vertex, d.vertex).empty()) return false;
    d.uv += whole_periods(raw_.surface, b.uv - triangles_[s][at_b].uv);
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

  Vec2 middle(const Corner& a, const Corner& b) const {
    Vec2 uv = (a.uv + b.uv) / 2;
    if (const auto free = free_[a.vertex]) uv.*free = b.uv.*free;
    if (const auto free = free_[b.vertex]) uv.*free = a.uv.*free;
    return uv;
  }

  int longest_side(int t) const {
    std::array<double, 3> squares{};
    for (int k = 0; k < 3; ++k)
      squares[k] = norm2(raw_.vertices[triangles_[t][k].vertex] - raw_.vertices[triangles_[t][(k + 1) % 3].vertex]);
    return static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  }

  /// Whether the middle of a side lies off the surface.
  bool is_off(const Triangle& t) const {
    for (int k = 0; k < 3; ++k) {
      const Corner &a = t[k], &b = t[(k + 1) % 3];
      const Vec3 chord = (raw_.vertices[a.vertex] + raw_.vertices[b.vertex]) / 2.0;
      if (distance(surface::point(raw_.surface, middle(a, b)), chord) > most_off * size_) return true;
    }
    return false;
  }

  int new_vertex(Vec3 x, Vec2 uv, bool is_fixed) {
    raw_.vertices.push_back(x), normals_.push_back(normal(uv));
    around_.emplace_back(), is_fixed_.push_back(is_fixed), free_.push_back(nullptr);
    return static_cast<int>(raw_.vertices.size()) - 1;
  }

  /// The side from corner k to the next one.
  void split_side(int t, int k) {
    const Corner a = triangles_[t][k], b = triangles_[t][(k + 1) % 3], c = triangles_[t][(k + 2) % 3];
    const std::vector<int> both = triangles_with(a.vertex, b.vertex);
    const bool is_boundary = both.size() == 1;
    const Corner m =
        is_boundary ? split_edge(a, b)
                    : Corner{new_vertex(surface::point(raw_.surface, middle(a, b)), middle(a, b), false), middle(a, b)};
    replace(t, {a, m, c}), add({m, b, c});
    if (is_boundary) return;
    const int s = both[0] == t ? both[1] : both[0], at_b = position(s, b.vertex);
    const Corner other_b = triangles_[s][at_b], other_a = triangles_[s][(at_b + 1) % 3],
                 d = triangles_[s][(at_b + 2) % 3];
    const Corner other_m{m.vertex, middle(other_a, other_b)};
    replace(s, {other_b, other_m, d}), add({other_m, other_a, d});
  }

  /// In the middle of the parameters of its curve.
  Corner split_edge(const Corner& a, const Corner& b) {
    for (EdgePolygon& polygon : raw_.polygons)
      for (std::size_t i = 0; i + 1 < polygon.vertices.size(); ++i) {
        const std::pair side{polygon.vertices[i], polygon.vertices[i + 1]};
        if (side != std::pair{a.vertex, b.vertex} && side != std::pair{b.vertex, a.vertex}) continue;
        const double t = (polygon.parameters[i] + polygon.parameters[i + 1]) / 2;
        const auto at = surface::project(raw_.surface, surface::point(raw_.curves[polygon.edge], t), middle(a, b));
        const int m = new_vertex(at.position, at.uv, true);
        polygon.vertices.insert(polygon.vertices.begin() + static_cast<long>(i) + 1, m);
        polygon.parameters.insert(polygon.parameters.begin() + static_cast<long>(i) + 1, t);
        return {m, at.uv + whole_periods(raw_.surface, middle(a, b) - at.uv)};
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

  std::set<int> neighbours(int v) const {
    std::set<int> found;
    for (const int t : around_[v])
      for (const Corner& c : triangles_[t])
        if (c.vertex != v) found.insert(c.vertex);
    return found;
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
      Corner& corner = triangle[position(t, v)];
      corner = {w, w_uv + whole_periods(raw_.surface, corner.uv - v_uv)};
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

  RawSpaceFace& raw_;
  std::vector<Triangle> triangles_;  ///< vertex -1: removed
  std::vector<double> shapes_;
  std::vector<std::vector<int>> around_;  ///< triangles at each vertex
  std::vector<bool> is_fixed_;
  std::vector<double Vec2::*> free_ = std::vector<double Vec2::*>(around_.size(), nullptr);  ///< at poles
  std::vector<Vec3> normals_ = std::vector<Vec3>(around_.size());
  double size_ = 0, least_area_ = 0;  ///< of the face in space; of a triangle in the parameters
};

}  // namespace

void improve_triangles(RawSpaceFace& raw) {
  Improver improver(raw);
  improver.improve();
  improver.store();
}

}  // namespace quadrille::space
