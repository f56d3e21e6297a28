#include "mesh/chart_map.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::mesh {
namespace {

constexpr double farthest_outside = 0.5;  ///< of a triangle, in barycentric coordinates: polynomials are useless beyond
constexpr double beside_outline = 1e-8;   ///< diameters, by which boundary curves and triangles differ as a rule
constexpr double farthest_radii = 4;      ///< of a triangle, from its centre: points so far outside are no nearer to it
/// Diameters: a projection that moves a point farther is at a wrong place. Coarse elements may be as far away.
constexpr double farthest_projection = 0.05;

/// The triangles' maps to a pair of nodal values.
template <typename Pair>
std::vector<spectral::TriMap> maps_of(const Chart& chart, const Pair& pair) {
  std::vector<Vec2> values;
  for (std::size_t i = 0; i < chart.nodes.size(); ++i) values.push_back(pair(i));
  std::vector<spectral::TriMap> maps;
  for (int e = 0; e < chart.num_elems(); ++e)
    maps.emplace_back(chart.order, values.data() + e * chart.nodes_per_elem());
  return maps;
}

int nearest_node(int order, Vec2 xi) {
  const std::vector<Vec2>& nodes = spectral::tri_nodes(order);
  return static_cast<int>(
      std::min_element(nodes.begin(), nodes.end(), [&](Vec2 a, Vec2 b) { return norm2(a - xi) < norm2(b - xi); }) -
      nodes.begin());
}

/// The nodes of the reference triangle, the nearest to xi first.
std::vector<int> nodes_by_distance(int order, Vec2 xi) {
  const std::vector<Vec2>& nodes = spectral::tri_nodes(order);
  std::vector<int> sorted(nodes.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(), [&](int a, int b) {
    const double da = norm2(nodes[a] - xi), db = norm2(nodes[b] - xi);
    return da != db ? da < db : a < b;
  });
  return sorted;
}

}  // namespace

TriMesh chart_triangles(const CadFace& face) {
  const Chart& chart = *face.chart;
  TriMesh mesh;
  mesh.face = face;
  mesh.order = chart.order;
  std::map<int, int> vertices;
  for (int e = 0; e < chart.num_elems(); ++e) {
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      const auto [at, is_new] = vertices.try_emplace(chart.elem2vertices[e][k], static_cast<int>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(chart.nodes[e * chart.nodes_per_elem() + k]);
      corners[k] = at->second;
    }
    mesh.elem2vertices.push_back(corners);
    mesh.curved_elems.push_back(e);
  }
  mesh.curved_nodes = chart.nodes;
  mesh.elem_layer.assign(chart.num_elems(), -1);
  return mesh;
}

ChartMap::ChartMap(const CadFace& face)
    : face_(face),
      chart_(*face.chart),
      maps_(maps_of(chart_, [&](std::size_t i) { return chart_.nodes[i]; })),
      space_xy_(maps_of(chart_,
                        [&](std::size_t i) {
                          return Vec2{chart_.space_nodes[i].x, chart_.space_nodes[i].y};
                        })),
      space_z_scale_(maps_of(chart_,
                             [&](std::size_t i) {
                               return Vec2{chart_.space_nodes[i].z, chart_.log_scale[i]};
                             })),
      locator_(chart_triangles(face), maps_) {
  for (int e = 0; e < chart_.num_elems(); ++e) balls_.push_back(ball_around(e));
}

ChartMap::Ball ChartMap::ball_around(int elem) const {
  const int count = chart_.nodes_per_elem(), first = elem * count;
  Ball ball;
  for (int i = first; i < first + count; ++i)
    ball.centre += chart_.nodes[i] / count, ball.space_centre += chart_.space_nodes[i] / count;
  for (int i = first; i < first + count; ++i) {
    ball.radius = std::max(ball.radius, distance(ball.centre, chart_.nodes[i]));
    ball.space_radius = std::max(ball.space_radius, distance(ball.space_centre, chart_.space_nodes[i]));
  }
  return ball;
}

Location ChartMap::locate(Vec2 x) const {
  if (const Location at = locator_.find(x, beside_outline * face_.diameter); at.elem >= 0) return at;
  Location nearest;
  double least = HUGE_VAL;
  for (int e = 0; e < chart_.num_elems(); ++e) {
    Vec2 xi{-1.0 / 3, -1.0 / 3};
    if (locator_.distance_to_box(e, x) > least) continue;
    if (distance(x, balls_[e].centre) > farthest_radii * balls_[e].radius) continue;
    if (!maps_[e].invert(x, xi) || outside_reference(xi) > farthest_outside) continue;
    const Vec2* corners = &chart_.nodes[e * chart_.nodes_per_elem()];
    const double off =
        outside_reference(xi) * std::max(distance(corners[0], corners[1]), distance(corners[0], corners[2]));
    if (off < least) least = off, nearest = {e, xi};
  }
  if (nearest.elem >= 0) return nearest;
  // Far outside: the nearest node of all.
  const auto node = std::min_element(chart_.nodes.begin(), chart_.nodes.end(),
                                     [&](Vec2 a, Vec2 b) { return norm2(a - x) < norm2(b - x); }) -
                    chart_.nodes.begin();
  return {static_cast<int>(node / chart_.nodes_per_elem()),
          spectral::tri_nodes(chart_.order)[node % chart_.nodes_per_elem()]};
}

Vec3 ChartMap::on_polynomial(Location at) const {
  const Vec2 xy = space_xy_[at.elem].position(at.xi);
  return {xy.x, xy.y, space_z_scale_[at.elem].position(at.xi).x};
}

// A node at a pole of the parametrisation may lead nowhere: then the others are tried, near ones first.
surface::SurfaceProjection ChartMap::projected(Vec3 position, Location at) const {
  const NurbsSurface& surface = chart_.surfaces[chart_.elem_surface[at.elem]];
  surface::SurfaceProjection best;
  best.distance = HUGE_VAL;
  const auto is_found_from = [&](int node) {
    const Vec2 uv = chart_.uv[at.elem * chart_.nodes_per_elem() + node];
    const surface::SurfaceProjection foot = surface::project(surface, position, uv);
    if (foot.distance < best.distance) best = foot;
    return is_near(foot);
  };
  if (is_found_from(nearest_node(chart_.order, at.xi))) return best;
  for (const int node : nodes_by_distance(chart_.order, at.xi))
    if (is_found_from(node)) break;
  return best;
}

bool ChartMap::is_near(const surface::SurfaceProjection& foot) const {
  return foot.is_converged && foot.distance <= farthest_projection * face_.diameter;
}

Vec3 ChartMap::lift(Vec2 x) const {
  const Location at = locate(x);
  return projected(on_polynomial(at), at).position;
}

double ChartMap::log_scale(Vec2 x) const {
  const Location at = locate(x);
  return space_z_scale_[at.elem].position(at.xi).y;
}

ChartMap::Sample ChartMap::sample(Vec2 x) const {
  const Location at = locate(x);
  const Vec2 xy = space_xy_[at.elem].position(at.xi), z_scale = space_z_scale_[at.elem].position(at.xi);
  return {{xy.x, xy.y, z_scale.x}, z_scale.y};
}

/// Derivatives by the reference coordinates.
struct ChartMap::Tangents {
  Vec3 position, first, second;
  Vec2 log_scale;  ///< of lambda
};

ChartMap::Tangents ChartMap::tangents(Location at) const {
  Vec2 position, z_scale;
  Mat2 xy, z;
  space_xy_[at.elem].evaluate(at.xi, position, xy);
  space_z_scale_[at.elem].evaluate(at.xi, z_scale, z);
  return {{position.x, position.y, z_scale.x}, {xy.xx, xy.yx, z.xx}, {xy.xy, xy.yy, z.xy}, {z.yx, z.yy}};
}

Vec3 ChartMap::normal(Vec2 x) const {
  const Tangents at = tangents(locate(x));
  return normalized(cross(at.first, at.second));
}

double ChartMap::greatest_curvature(Vec2 x) const {
  const Location at = locate(x);
  return surface::greatest_curvature(chart_.surfaces[chart_.elem_surface[at.elem]],
                                     projected(on_polynomial(at), at).uv);
}

std::array<Vec3, 2> ChartMap::derivatives(Vec2 x) const {
  const Location at = locate(x);
  const Tangents in_space = tangents(at);
  Vec2 position;
  Mat2 in_chart;
  maps_[at.elem].evaluate(at.xi, position, in_chart);
  const Mat2 back = inverse(in_chart);
  return {back.xx * in_space.first + back.yx * in_space.second, back.xy * in_space.first + back.yy * in_space.second};
}

double ChartMap::log_scale(Vec2 x, Vec2& gradient) const {
  const Location at = locate(x);
  const Vec2 slope = tangents(at).log_scale;
  Vec2 position;
  Mat2 in_chart;
  maps_[at.elem].evaluate(at.xi, position, in_chart);
  const Mat2 back = inverse(in_chart);
  gradient = {back.xx * slope.x + back.yx * slope.y, back.xy * slope.x + back.yy * slope.y};
  return space_z_scale_[at.elem].position(at.xi).y;
}

// In the tiny triangles at a tip lambda has an error that does not become smaller with them, and so has any gradient:
// there it is the variation over a length below all sizes, and nothing where no size is sampled.
double ChartMap::greatest_gradient() const {
  constexpr double least_length = 1e-3, least_radius = 1e-5;  // diameters
  double greatest = 0;
  for (int e = 0; e < chart_.num_elems(); ++e) {
    if (balls_[e].radius < least_radius * face_.diameter) continue;
    double in_triangle = 0;
    for (const Vec2 xi : spectral::tri_nodes(chart_.order)) {
      const Tangents at = tangents({e, xi});
      // |grad lambda|^2 by the metric J^T J.
      const double g11 = norm2(at.first), g12 = dot(at.first, at.second), g22 = norm2(at.second);
      const Vec2 d = at.log_scale;
      const double square = (g22 * d.x * d.x - 2 * g12 * d.x * d.y + g11 * d.y * d.y) / (g11 * g22 - g12 * g12);
      in_triangle = std::max(in_triangle, std::sqrt(std::max(0.0, square)));
    }
    const auto first = chart_.log_scale.begin() + e * chart_.nodes_per_elem();
    const auto [least, most] = std::minmax_element(first, first + chart_.nodes_per_elem());
    greatest = std::max(greatest, std::min(in_triangle, (*most - *least) / (least_length * face_.diameter)));
  }
  return greatest;
}

/// The foot on one triangle's polynomial, by Gauss and Newton from its nearest node; none outside of it.
std::optional<ChartMap::Foot> ChartMap::foot_on(int elem, Vec3 position) const {
  constexpr int most_steps = 40;
  constexpr double beside = 1e-6, converged = 1e-12;  // of the reference triangle
  const Vec3* nodes = &chart_.space_nodes[elem * chart_.nodes_per_elem()];
  const auto node = std::min_element(nodes, nodes + chart_.nodes_per_elem(),
                                     [&](Vec3 a, Vec3 b) { return norm2(a - position) < norm2(b - position); });
  Vec2 xi = spectral::tri_nodes(chart_.order)[node - nodes];
  for (int step = 0; step < most_steps; ++step) {
    const Tangents at = tangents({elem, xi});
    const Vec3 r = position - at.position;
    const double g11 = norm2(at.first), g12 = dot(at.first, at.second), g22 = norm2(at.second);
    const Vec2 move = inverse(Mat2{g11, g12, g12, g22}) * Vec2{dot(r, at.first), dot(r, at.second)};
    xi += move;
    if (!(outside_reference(xi) <= farthest_outside)) return std::nullopt;
    if (norm(move) > converged) continue;
    if (outside_reference(xi) > beside) return std::nullopt;
    return Foot{maps_[elem].position(xi), distance(position, on_polynomial({elem, xi}))};
  }
  return std::nullopt;
}

// It is inside, in a triangle, or on the boundary.
ChartMap::Foot ChartMap::nearest(Vec3 position) const {
  Foot best;
  best.distance = HUGE_VAL;
  for (int c = 0; c < std::ssize(chart_.space_curves); ++c) {
    const surface::CurveProjection foot = surface::project(chart_.space_curves[c], position);
    if (foot.distance < best.distance) best = {curve::point(face_.curves[c], foot.t), foot.distance};
  }
  for (int e = 0; e < chart_.num_elems(); ++e) {
    if (distance(position, balls_[e].space_centre) - balls_[e].space_radius > best.distance) continue;
    if (const auto foot = foot_on(e, position); foot && foot->distance < best.distance) best = *foot;
  }
  return best;
}

Vec3 ChartMap::boundary_point(int curve, double t) const { return surface::point(chart_.space_curves[curve], t); }

double ChartMap::distance_from_surface(Vec3 position, Vec2 x, std::optional<Vec2>& uv) const {
  surface::SurfaceProjection foot;
  if (uv && chart_.surfaces.size() == 1) foot = surface::project(chart_.surfaces.front(), position, *uv);
  if (!is_near(foot)) foot = projected(position, locate(x));
  uv = foot.uv;
  return foot.distance;
}

}  // namespace quadrille::mesh
