#include "chart/surface_mesh.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "chart/element_tables.hpp"
#include "mesh/locate.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::chart {
namespace {

/// A point of the surface with its parameters.
struct Foot {
  Vec3 x;
  Vec2 uv;
};

std::array<double, 3> barycentric(Vec2 xi) { return {-(xi.x + xi.y) / 2, (1 + xi.x) / 2, (1 + xi.y) / 2}; }

/// The period of closed parameters, 0 for others.
Vec2 periods(const NurbsSurface& s) {
  return {s.is_closed_u ? s.knots_u.back() - s.knots_u.front() : 0,
          s.is_closed_v ? s.knots_v.back() - s.knots_v.front() : 0};
}

double nearest_turn(double value, double to, double period) {
  return period > 0 ? value - period * std::round((value - to) / period) : value;
}

class Lift {
 public:
  Lift(const SpaceFace& face, const std::vector<SpaceLength>& lengths, const SurfaceMesh& last)
      : face_(&face), lengths_(&lengths), last_(&last), period_(periods(face.surface)) {
    const int n = last.nodes_per_elem();
    maps_.reserve(last.num_elems());
    for (int e = 0; e < last.num_elems(); ++e) {
      const Vec2* image = &last.image[static_cast<std::size_t>(n) * e];
      if (last.order == 1)
        maps_.emplace_back(std::array{image[0], image[1], image[2]});
      else
        maps_.emplace_back(last.order, image);
    }
  }

  SurfaceMesh lifted(TriMesh plane, int order) const;

 private:
  Vec2 blend(const std::array<double, 3>& weights, const std::array<Vec2, 3>& uv) const;
  Foot project(Vec3 x, Vec2 first, const std::array<Vec2, 3>& others, double size) const;
  mesh::Location locate(const mesh::Locator& locator, Vec2 x) const;
  void lift_inner_vertices(const TriMesh& plane, std::vector<Foot>& vertices) const;
  void lift_boundary_vertices(const TriMesh& plane, std::vector<Foot>& vertices) const;
  void blend_edge(const BoundaryEdge& edge, SurfaceMesh& mesh) const;
  void project_nodes(const std::vector<Foot>& vertices, SurfaceMesh& mesh) const;
  void set_normals(SurfaceMesh& mesh) const;

  const SpaceFace* face_;
  const std::vector<SpaceLength>* lengths_;
  const SurfaceMesh* last_;
  std::vector<spectral::TriMap> maps_;
  Vec2 period_;
};

// The corner of the greatest weight decides in which period.
Vec2 Lift::blend(const std::array<double, 3>& weights, const std::array<Vec2, 3>& uv) const {
  const Vec2 main = uv[std::max_element(weights.begin(), weights.end()) - weights.begin()];
  Vec2 sum;
  for (int i = 0; i < 3; ++i)
    sum += weights[i] * Vec2{nearest_turn(uv[i].x, main.x, period_.x), nearest_turn(uv[i].y, main.y, period_.y)};
  return sum;
}

// Near a pole blended parameters say nothing: the nearest of the other guesses is taken where they are far off.
Foot Lift::project(Vec3 x, Vec2 first, const std::array<Vec2, 3>& others, double size) const {
  constexpr double rounding = 1e-12;
  const auto off = [&](Vec2 uv) { return distance(surface::point(face_->surface, uv), x); };
  Vec2 guess = first;
  double least = off(guess);
  if (least > 0.1 * size)
    for (const Vec2 uv : others)
      if (const double d = off(uv); d < least) guess = uv, least = d;
  const surface::SurfaceProjection found = surface::project(face_->surface, x, guess);
  if (!(found.distance <= least + rounding * (norm(x) + size)))
    throw ComputeError("the surface has no point near " + position_text(x));
  return {found.position, found.uv};
}

// A vertex between a curve and the rough triangles lies in none: it is moved to the nearest node.
mesh::Location Lift::locate(const mesh::Locator& locator, Vec2 x) const {
  const mesh::Location found = locator.find(x);
  if (found.elem >= 0) return found;
  const auto nearest = std::min_element(last_->image.begin(), last_->image.end(),
                                        [&](Vec2 a, Vec2 b) { return norm2(a - x) < norm2(b - x); });
  const auto node = static_cast<int>(nearest - last_->image.begin()), n = last_->nodes_per_elem();
  return {node / n, spectral::tri_nodes(last_->order)[node % n]};
}

void Lift::lift_inner_vertices(const TriMesh& plane, std::vector<Foot>& vertices) const {
  const mesh::Locator locator(last_->plane, maps_);
  const ElementTables& tables = element_tables(last_->order);
  std::vector<bool> is_on_boundary(plane.vertices.size(), false);
  for (const BoundaryEdge& b : plane.boundary_edges)
    for (const int k : {b.edge, (b.edge + 1) % 3}) is_on_boundary[plane.elem2vertices[b.elem][k]] = true;
  for (std::size_t v = 0; v < plane.vertices.size(); ++v) {
    if (is_on_boundary[v]) continue;
    const mesh::Location at = locate(locator, plane.vertices[v]);
    const std::size_t first = static_cast<std::size_t>(last_->nodes_per_elem()) * at.elem;
    const Eigen::RowVectorXd values = node_functions(tables, at.xi);
    Vec3 x;
    for (Eigen::Index i = 0; i < values.size(); ++i) x += values[i] * last_->nodes[first + i];
    const std::array<Vec2, 3> uv{last_->uv[first], last_->uv[first + 1], last_->uv[first + 2]};
    vertices[v] = project(x, blend(barycentric(at.xi), uv), uv, distance(last_->nodes[first], last_->nodes[first + 1]));
  }
}

void Lift::lift_boundary_vertices(const TriMesh& plane, std::vector<Foot>& vertices) const {
  for (const BoundaryEdge& b : plane.boundary_edges) {
    const SpaceCurve& curve = face_->curves[b.curve];
    const auto& edges = last_->plane.boundary_edges;
    const auto after =
        std::upper_bound(edges.begin(), edges.end(), b, [](const BoundaryEdge& x, const BoundaryEdge& y) {
          return x.curve != y.curve ? x.curve < y.curve : x.t0 < y.t0;
        });
    const BoundaryEdge& near = after == edges.begin() ? *after : *(after - 1);
    const std::size_t first = static_cast<std::size_t>(last_->nodes_per_elem()) * near.elem;
    const double part = std::clamp((b.t0 - near.t0) / (near.t1 - near.t0), 0.0, 1.0);
    std::array<double, 3> weights{};
    weights[near.edge] = 1 - part, weights[(near.edge + 1) % 3] = part;
    const std::array<Vec2, 3> uv{last_->uv[first], last_->uv[first + 1], last_->uv[first + 2]};
    const Vec3 x = surface::point(curve, b.t0);
    const double size = distance(last_->nodes[first + near.edge], last_->nodes[first + (near.edge + 1) % 3]);
    vertices[plane.elem2vertices[b.elem][b.edge]] = {x, project(x, blend(weights, uv), uv, size).uv};
  }
}

// The nodes of the edge at Gauss-Lobatto-Legendre fractions of the curve's length; those inside the element by the
// blending of triangulate/curved_edges: lambda_a lambda_b q(lambda_b - lambda_a), q the distance of the edge from its
// chord over its own lambda_a lambda_b.
void Lift::blend_edge(const BoundaryEdge& edge, SurfaceMesh& mesh) const {
  const int order = mesh.order, n = mesh.nodes_per_elem(), a = edge.edge, b = (edge.edge + 1) % 3;
  Vec3* const nodes = &mesh.nodes[static_cast<std::size_t>(n) * edge.elem];
  const SpaceLength& length = (*lengths_)[edge.curve];
  const double s0 = length.at(edge.t0), s1 = length.at(edge.t1);
  const std::vector<double>& gll = spectral::gll_points(order);
  std::vector<Vec3> off(order + 1);
  for (int j = 1; j < order; ++j) {
    const double part = (1 + gll[j]) / 2;
    const Vec3 x = surface::point(length.curve(), length.parameter(s0 + part * (s1 - s0)));
    off[j] = x - (nodes[a] + part * (nodes[b] - nodes[a]));
    nodes[spectral::tri_edge_node(order, a, j)] = x;
  }
  const std::vector<Vec2>& xi = spectral::tri_nodes(order);
  for (int i = 3 * order; i < n; ++i) {
    const std::array<double, 3> weights = barycentric(xi[i]);
    const double along = weights[b] - weights[a];
    const Eigen::MatrixXd values = spectral::interpolation_matrix(gll, {along});
    const double fade = 4 * weights[a] * weights[b] / (1 - along * along);
    for (int j = 1; j < order; ++j) nodes[i] += fade * values(0, j) * off[j];
  }
}

void Lift::project_nodes(const std::vector<Foot>& vertices, SurfaceMesh& mesh) const {
  const std::vector<Vec2>& xi = spectral::tri_nodes(mesh.order);
  const int n = mesh.nodes_per_elem();
  std::vector<bool> is_exact(mesh.nodes.size(), false);
  for (const BoundaryEdge& b : mesh.plane.boundary_edges)
    for (int j = 0; j <= mesh.order; ++j)
      is_exact[static_cast<std::size_t>(n) * b.elem + spectral::tri_edge_node(mesh.order, b.edge, j)] = true;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    std::array<Vec2, 3> uv;
    for (int k = 0; k < 3; ++k) uv[k] = vertices[mesh.plane.elem2vertices[e][k]].uv;
    const std::size_t first = static_cast<std::size_t>(n) * e;
    const double size = distance(mesh.nodes[first], mesh.nodes[first + 1]);
    for (int i = 0; i < n; ++i) {
      Foot foot{mesh.nodes[first + i], uv[i % 3]};
      if (i >= 3) foot = project(foot.x, blend(barycentric(xi[i]), uv), uv, size);
      if (i >= 3 && !is_exact[first + i]) mesh.nodes[first + i] = foot.x;
      mesh.uv[first + i] = foot.uv;
    }
  }
}

// Where the parametrisation degenerates, that of the element's polynomial.
void Lift::set_normals(SurfaceMesh& mesh) const {
  const ElementTables& tables = element_tables(mesh.order);
  const int n = mesh.nodes_per_elem();
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    mesh.normals[i] = face_normal(*face_, mesh.uv[i]);
    if (norm2(mesh.normals[i]) > 0) continue;
    const std::size_t first = i - i % n;
    Vec3 x1, x2;
    for (int j = 0; j < n; ++j) {
      x1 += tables.at_nodes_xi1(static_cast<Eigen::Index>(i % n), j) * mesh.nodes[first + j];
      x2 += tables.at_nodes_xi2(static_cast<Eigen::Index>(i % n), j) * mesh.nodes[first + j];
    }
    mesh.normals[i] = normalized(cross(x1, x2));
  }
}

SurfaceMesh Lift::lifted(TriMesh plane, int order) const {
  SurfaceMesh mesh;
  mesh.order = order;
  std::vector<Foot> vertices(plane.vertices.size());
  lift_boundary_vertices(plane, vertices);
  lift_inner_vertices(plane, vertices);
  mesh.plane = std::move(plane);
  const std::vector<Vec2>& xi = spectral::tri_nodes(order);
  for (const auto& corners : mesh.plane.elem2vertices)
    for (const Vec2 at : xi) {
      const std::array<double, 3> weights = barycentric(at);
      Vec3 x;
      for (int k = 0; k < 3; ++k) x += weights[k] * vertices[corners[k]].x;
      mesh.nodes.push_back(x);
    }
  mesh.uv.resize(mesh.nodes.size()), mesh.normals.resize(mesh.nodes.size());
  for (const BoundaryEdge& edge : mesh.plane.boundary_edges) blend_edge(edge, mesh);
  project_nodes(vertices, mesh);
  set_normals(mesh);
  return mesh;
}

}  // namespace

std::vector<double> least_area_ratios(const SurfaceMesh& mesh) {
  const ElementTables& tables = element_tables(mesh.order);
  const int n = mesh.nodes_per_elem();
  std::vector<double> ratios;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const Vec3* const x = &mesh.nodes[static_cast<std::size_t>(n) * e];
    const double area = norm(cross(x[1] - x[0], x[2] - x[0])) / 4;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < n; ++i) {
      Vec3 x1, x2;
      for (int j = 0; j < n; ++j) x1 += tables.at_nodes_xi1(i, j) * x[j], x2 += tables.at_nodes_xi2(i, j) * x[j];
      const double ratio = dot(cross(x1, x2), mesh.normals[static_cast<std::size_t>(n) * e + i]) / area;
      least = std::isfinite(ratio) ? std::min(least, ratio) : -std::numeric_limits<double>::infinity();
    }
    ratios.push_back(least);
  }
  return ratios;
}

Vec2 image_slope(const SurfaceMesh& mesh, const BoundaryEdge& edge, bool at_end) {
  const ElementTables& tables = element_tables(mesh.order);
  const Vec2 step = spectral::tri_edge_point(edge.edge, 1) - spectral::tri_edge_point(edge.edge, 0);
  const int node = (edge.edge + (at_end ? 1 : 0)) % 3, n = mesh.nodes_per_elem();
  Vec2 slope;
  for (int j = 0; j < n; ++j)
    slope += (step.x * tables.at_nodes_xi1(node, j) + step.y * tables.at_nodes_xi2(node, j)) *
             mesh.image[static_cast<std::size_t>(n) * edge.elem + j];
  return slope;
}

Vec3 face_normal(const SpaceFace& face, Vec2 uv) {
  constexpr double degenerate = 1e-8;  // of the angle between the derivatives, or of the ratio of their lengths
  const surface::SurfacePoint p = surface::evaluate(face.surface, uv);
  const Vec3 normal = cross(p.xu, p.xv);
  const double longest = std::max(norm2(p.xu), norm2(p.xv));
  if (!(norm(normal) > degenerate * longest)) return {};
  return (face.is_reversed ? -1 : 1) * normalized(normal);
}

CornerParameters corner_parameters(const SpaceFace& face, Vec2 uv) {
  if (norm2(face_normal(face, uv)) > 0) return {uv};
  const surface::SurfacePoint p = surface::evaluate(face.surface, uv);
  const bool is_u = norm2(p.xu) < norm2(p.xv);
  return {uv, !is_u, is_u};
}

SurfaceMesh lifted_mesh(const SpaceFace& face, const std::vector<SpaceLength>& lengths, const SurfaceMesh& last,
                        TriMesh plane, int order) {
  return Lift(face, lengths, last).lifted(std::move(plane), order);
}

}  // namespace quadrille::chart
