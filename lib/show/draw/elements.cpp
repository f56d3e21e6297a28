#include "draw/elements.hpp"

#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::draw {

std::vector<spectral::TriMap> element_maps(const TriMesh& mesh) {
  const std::size_t nodes_per_elem = static_cast<std::size_t>(mesh.order + 1) * (mesh.order + 2) / 2;
  std::vector<spectral::TriMap> maps;
  maps.reserve(mesh.elem2vertices.size());
  std::size_t curved = 0;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (curved < mesh.curved_elems.size() && mesh.curved_elems[curved] == e) {
      maps.emplace_back(mesh.order, &mesh.curved_nodes[nodes_per_elem * curved++]);
    } else {
      const auto& v = mesh.elem2vertices[e];
      maps.emplace_back(std::array<Vec2, 3>{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]});
    }
  }
  return maps;
}

PathData tri_outline(const Picture& picture, const spectral::TriMap& map) {
  PathData path;
  path.move_to(picture.at(map.position(spectral::tri_edge_point(0, 0))));
  for (int edge = 0; edge < 3; ++edge) {
    const Vec2 along = spectral::tri_edge_point(edge, 1) - spectral::tri_edge_point(edge, 0);
    const PixelCurve pixels = [&](double s) -> CurvePoint {
      Vec2 x;
      Mat2 dx_dxi;
      map.evaluate(spectral::tri_edge_point(edge, s), x, dx_dxi);
      return {picture.at(x), picture.scale() * (dx_dxi * along)};
    };
    if (map.is_affine() && edge == 2) break;  // closing the path draws it
    append_curve(path, pixels, 0, 1);
  }
  path.close();
  return path;
}

int quad_side_node(const QuadMesh& mesh, int elem, int side, int i) {
  const int n = mesh.order, m = n + 1;
  const int first = elem * m * m;
  switch (side) {
    case 0:
      return mesh.elem_nodes[first + i];
    case 1:
      return mesh.elem_nodes[first + i * m + n];
    case 2:
      return mesh.elem_nodes[first + n * m + n - i];
    default:
      return mesh.elem_nodes[first + (n - i) * m];
  }
}

PixelCurve quad_side(const Picture& picture, const QuadMesh& mesh, int elem, int side) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  const Eigen::Index m = mesh.order + 1;
  Eigen::MatrixXd positions(m, 2);
  for (int i = 0; i < m; ++i) {
    const Vec2 x = picture.at(mesh.nodes[quad_side_node(mesh, elem, side, i)]);
    positions.row(i) << x.x, x.y;
  }
  const Eigen::MatrixXd derivatives = spectral::differentiation_matrix(points) * positions;
  return [&points, positions, derivatives](double s) -> CurvePoint {
    const Eigen::MatrixXd row = spectral::interpolation_matrix(points, {2 * s - 1});
    const Eigen::RowVector2d x = row * positions, d = 2.0 * row * derivatives;
    return {{x(0), x(1)}, {d(0), d(1)}};
  };
}

PathData quad_outline(const Picture& picture, const QuadMesh& mesh, int elem) {
  PathData path;
  path.move_to(picture.at(mesh.nodes[quad_side_node(mesh, elem, 0, 0)]));
  for (int side = 0; side < 4; ++side) append_curve(path, quad_side(picture, mesh, elem, side), 0, 1);
  path.close();
  return path;
}

}  // namespace quadrille::draw
