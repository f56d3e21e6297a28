#include "mesh/lifted_mesh.hpp"

#include <algorithm>
#include <optional>

#include "curve/nearest_along.hpp"
#include "curve/nurbs.hpp"
#include "model/periodic.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::mesh {
namespace {

/// The distance from the curve, by Newton's method from the parameter t.
double distance_from_curve(const SpaceCurve& curve, Vec3 x, double t) {
  double least = distance(surface::point(curve, t), x);
  for (int step = 0; step < 4; ++step) {
    const auto [p, first, second] = surface::derivatives(curve, t);
    const double slope = norm2(first) + dot(p - x, second);
    if (!(slope > 0)) break;
    t = std::clamp(t - dot(p - x, first) / slope, curve.begin(), curve.end());
    least = std::min(least, distance(surface::point(curve, t), x));
  }
  return least;
}

/// From the nodes of an interval to the middles between them.
struct Middles {
  Eigen::MatrixXd map;

  explicit Middles(int order) {
    const std::vector<double>& nodes = spectral::gll_points(order);
    std::vector<double> middles;
    for (int i = 0; i < order; ++i) middles.push_back((nodes[i] + nodes[i + 1]) / 2);
    map = spectral::interpolation_matrix(nodes, middles);
  }
};

/// Sample (i, j) of the element's polynomial through `nodes`.
template <typename Point>
Point inside_at(const QuadMesh& mesh, const std::vector<Point>& nodes, int elem, const Eigen::MatrixXd& map, int i,
                int j) {
  Point sum{};
  const int* ids = &mesh.elem_nodes[elem * mesh.nodes_per_elem()];
  for (int b = 0; b <= mesh.order; ++b)
    for (int a = 0; a <= mesh.order; ++a) sum += map(i, a) * map(j, b) * nodes[ids[b * (mesh.order + 1) + a]];
  return sum;
}

template <typename Point>
Point edge_at(const std::vector<int>& ids, const std::vector<Point>& nodes, const Eigen::MatrixXd& map, int i) {
  Point sum{};
  for (std::size_t k = 0; k < ids.size(); ++k) sum += map(i, static_cast<Eigen::Index>(k)) * nodes[ids[k]];
  return sum;
}

/// Takes the greatest distances.
struct Worst {
  SurfaceDistance result;

  void add(int elem, double distance, Vec2 x) {
    if (!(distance > result.elem[elem])) return;
    result.elem[elem] = distance;
    if (distance > result.worst() || elem == result.worst_elem) result.worst_elem = elem, result.position = x;
  }
};

/// The end of the curve if x is there to the accuracy of its spline in the chart, else t: a node at a joint of curves
/// is the joint, in space and in the chart.
double end_if_there(const CadFace& face, int curve, double t, Vec2 x) {
  constexpr double same_place = 1e-8;  // diameters; splines are within 1e-9
  const Nurbs& spline = face.curves[curve];
  if (distance(x, spline.poles.front()) < same_place * face.diameter) return spline.begin();
  if (distance(x, spline.poles.back()) < same_place * face.diameter) return spline.end();
  return t;
}

/// A parameter of a curve; -1: a node is on none.
struct OnCurve {
  int curve = -1;
  double t = 0;
};

/// By curve, the boundary edges in the order of the loop.
std::vector<std::vector<QuadBoundaryEdge>> edges_of_curves(const QuadMesh& mesh) {
  std::vector<std::vector<QuadBoundaryEdge>> edges(mesh.face.curves.size());
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges) edges[edge.curve].push_back(edge);
  return edges;
}

/// Nodes on the second of two periodic curves are at the parameters of those on the first: lengths along the two curves
/// in the chart, by which they were placed, are equal to its accuracy alone. Nodes at ends of curves stay there.
void place_images(const ChartMap& map, const std::vector<OnCurve>& points, QuadMesh& mesh) {
  if (mesh.face.periodic_pairs.empty()) return;
  const std::vector<std::vector<QuadBoundaryEdge>> edges = edges_of_curves(mesh);
  for (const PeriodicPair& pair : mesh.face.periodic_pairs) {
    const auto [first, second] = pair.curves;
    if (edges[first].size() != edges[second].size()) continue;
    for (std::size_t k = 0; k < edges[first].size(); ++k) {
      const QuadBoundaryEdge &edge = edges[first][k], &image = edges[second][edges[second].size() - 1 - k];
      for (int j = 0; j <= mesh.order; ++j) {
        const OnCurve at = points[side_node(mesh, edge.elem, edge.side, j)];
        if (at.curve != first || at.t == mesh.face.curves[first].begin() || at.t == mesh.face.curves[first].end())
          continue;
        mesh.space_nodes[side_node(mesh, image.elem, image.side, mesh.order - j)] =
            map.boundary_point(second, periodic_parameter(mesh.face, first, at.t, second));
      }
    }
  }
}

}  // namespace

void lift_nodes(const ChartMap& map, QuadMesh& mesh) {
  const curve::FaceBoundary boundary(mesh.face);
  mesh.space_nodes.assign(mesh.nodes.size(), {});
  std::vector<bool> is_placed(mesh.nodes.size(), false);
  std::vector<OnCurve> points(mesh.nodes.size());
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& edge : *edges)
      for (const int node : side_nodes(mesh, edge.elem, edge.side)) {
        if (is_placed[node]) continue;
        const curve::NearestPoint at = curve::nearest_along(boundary, edge.curve, mesh.nodes[node]);
        const double t = end_if_there(mesh.face, at.curve, at.t, mesh.nodes[node]);
        if (t != at.t) mesh.nodes[node] = curve::point(mesh.face.curves[at.curve], t);
        points[node] = {at.curve, t};
        mesh.space_nodes[node] = map.boundary_point(at.curve, t);
        is_placed[node] = true;
      }
  place_images(map, points, mesh);
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
    if (!is_placed[node]) mesh.space_nodes[node] = map.lift(mesh.nodes[node]);
}

SurfaceDistance surface_distance(const ChartMap& map, const QuadMesh& mesh) {
  const Eigen::MatrixXd& middles = spectral::table_per_order<Middles>(mesh.order).map;
  Worst worst{{std::vector<double>(mesh.num_elems(), 0.0), 0, mesh.nodes.front()}};
  const int count = static_cast<int>(middles.rows());
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    std::optional<Vec2> uv;
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) {
        const Vec2 x = inside_at(mesh, mesh.nodes, elem, middles, i, j);
        const Vec3 position = inside_at(mesh, mesh.space_nodes, elem, middles, i, j);
        worst.add(elem, map.distance_from_surface(position, x, uv), x);
      }
  }
  const curve::FaceBoundary boundary(mesh.face);
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges) {
    const std::vector<int> ids = side_nodes(mesh, edge.elem, edge.side);
    for (int i = 0; i < middles.rows(); ++i) {
      const Vec2 x = edge_at(ids, mesh.nodes, middles, i);
      const Vec3 position = edge_at(ids, mesh.space_nodes, middles, i);
      const curve::NearestPoint at = curve::nearest_along(boundary, edge.curve, x);
      worst.add(edge.elem, distance_from_curve(mesh.face.chart->space_curves[at.curve], position, at.t), x);
    }
  }
  return worst.result;
}

}  // namespace quadrille::mesh
