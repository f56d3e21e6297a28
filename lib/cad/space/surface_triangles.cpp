#include "space/surface_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/vec3.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::space {

SurfaceTriangles::SurfaceTriangles(RawSpaceFace& raw)
    : raw_(raw),
      around_(raw.vertices.size()),
      is_fixed_(raw.vertices.size(), false),
      free_(raw.vertices.size(), nullptr),
      normals_(raw.vertices.size()) {
  for (std::size_t t = 0; t < raw.triangles.size(); ++t) {
    Triangle triangle{};
    for (int k = 0; k < 3; ++k) triangle[k] = {raw.triangles[t][k], raw.triangle_uv[t][k]};
    for (const SurfaceCorner& c : triangle) around_[c.vertex].push_back(static_cast<int>(t));
    triangles_.push_back(triangle);
  }
  for (const Vec3& x : raw.vertices) size_ = std::max(size_, distance(x, raw.vertices.front()));
  least_area_ = 1e-12 * (raw.surface.knots_u.back() - raw.surface.knots_u.front()) *
                (raw.surface.knots_v.back() - raw.surface.knots_v.front());
  fix_vertices();
  for (Triangle& t : triangles_) set_poles(t), shapes_.push_back(shape(t));
}

void SurfaceTriangles::store() {
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

Vec3 SurfaceTriangles::normal(Vec2 uv) const {
  const auto p = surface::evaluate(raw_.surface, uv);
  const double xu = norm(p.xu), xv = norm(p.xv);
  if (std::min(xu, xv) <= 1e-9 * std::max(xu, xv)) return {};
  return (raw_.is_reversed ? -1.0 : 1.0) * normalized(cross(p.xu, p.xv));
}

double SurfaceTriangles::shape(const Triangle& t) const {
  const Vec3 &a = raw_.vertices[t[0].vertex], &b = raw_.vertices[t[1].vertex], &c = raw_.vertices[t[2].vertex];
  const Vec3 along = normals_[t[0].vertex] + normals_[t[1].vertex] + normals_[t[2].vertex];
  const double twice_area = dot(cross(b - a, c - a), along) / norm(along);
  return 2 * std::sqrt(3.0) * twice_area / (norm2(b - a) + norm2(c - b) + norm2(a - c));
}

double SurfaceTriangles::checked_shape(const Triangle& t) const {
  const double area = cross(t[1].uv - t[0].uv, t[2].uv - t[0].uv) * (raw_.is_reversed ? -1 : 1);
  return area > least_area_ ? shape(t) : -1;
}

void SurfaceTriangles::fix_vertices() {
  for (const EdgePolygon& polygon : raw_.polygons)
    for (const int v : polygon.vertices) is_fixed_[v] = true;
  for (const Triangle& t : triangles_)
    for (const SurfaceCorner& c : t) {
      const auto p = surface::evaluate(raw_.surface, c.uv);
      const double xu = norm(p.xu), xv = norm(p.xv), least = 1e-9 * std::max(xu, xv);
      if (xu <= least) free_[c.vertex] = &Vec2::x;
      if (xv <= least) free_[c.vertex] = &Vec2::y;
      if (is_pole(c.vertex)) is_fixed_[c.vertex] = true;
      normals_[c.vertex] = normal(c.uv);
    }
}

void SurfaceTriangles::set_poles(Triangle& t) const {
  for (int k = 0; k < 3; ++k)
    if (const auto free = free_[t[k].vertex]) t[k].uv.*free = (t[(k + 1) % 3].uv.*free + t[(k + 2) % 3].uv.*free) / 2;
}

int SurfaceTriangles::position(int t, int vertex) const {
  for (int k = 0; k < 3; ++k)
    if (triangles_[t][k].vertex == vertex) return k;
  return -1;
}

std::vector<int> SurfaceTriangles::triangles_with(int a, int b) const {
  std::vector<int> found;
  for (const int t : around_[a])
    if (position(t, b) >= 0) found.push_back(t);
  return found;
}

void SurfaceTriangles::replace(int t, const Triangle& triangle) {
  for (const SurfaceCorner& c : triangles_[t]) std::erase(around_[c.vertex], t);
  for (const SurfaceCorner& c : triangle) around_[c.vertex].push_back(t);
  triangles_[t] = triangle;
  set_poles(triangles_[t]);
  shapes_[t] = shape(triangles_[t]);
}

void SurfaceTriangles::add(const Triangle& triangle) {
  for (const SurfaceCorner& c : triangle) around_[c.vertex].push_back(static_cast<int>(triangles_.size()));
  triangles_.push_back(triangle);
  set_poles(triangles_.back());
  shapes_.push_back(shape(triangles_.back()));
}

void SurfaceTriangles::remove(int t) {
  for (const SurfaceCorner& c : triangles_[t]) std::erase(around_[c.vertex], t);
  triangles_[t][0].vertex = -1, shapes_[t] = 1;
}

std::set<int> SurfaceTriangles::neighbours(int v) const {
  std::set<int> found;
  for (const int t : around_[v])
    for (const SurfaceCorner& c : triangles_[t])
      if (c.vertex != v) found.insert(c.vertex);
  return found;
}

Vec2 SurfaceTriangles::middle(const SurfaceCorner& a, const SurfaceCorner& b) const {
  Vec2 uv = (a.uv + b.uv) / 2;
  if (const auto free = free_[a.vertex]) uv.*free = b.uv.*free;
  if (const auto free = free_[b.vertex]) uv.*free = a.uv.*free;
  return uv;
}

int SurfaceTriangles::longest_side(int t) const {
  std::array<double, 3> squares{};
  for (int k = 0; k < 3; ++k)
    squares[k] = norm2(raw_.vertices[triangles_[t][k].vertex] - raw_.vertices[triangles_[t][(k + 1) % 3].vertex]);
  return static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
}

int SurfaceTriangles::new_vertex(Vec3 x, Vec2 uv, bool is_fixed) {
  raw_.vertices.push_back(x), normals_.push_back(normal(uv));
  around_.emplace_back(), is_fixed_.push_back(is_fixed), free_.push_back(nullptr);
  return static_cast<int>(raw_.vertices.size()) - 1;
}

Vec2 SurfaceTriangles::whole_periods(Vec2 difference) const {
  const NurbsSurface& s = raw_.surface;
  const double u = s.knots_u.back() - s.knots_u.front(), v = s.knots_v.back() - s.knots_v.front();
  return {s.is_closed_u ? u * std::round(difference.x / u) : 0, s.is_closed_v ? v * std::round(difference.y / v) : 0};
}

}  // namespace quadrille::space
