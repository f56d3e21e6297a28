#include "draw/elements.hpp"

#include "model/quad_sides.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_nodes.hpp"

namespace quadrille::draw {

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

PixelCurve quad_side(const Picture& picture, const QuadMesh& mesh, int elem, int side) {
  const std::vector<double>& points = spectral::gll_points(mesh.order);
  const Eigen::Index m = mesh.order + 1;
  Eigen::MatrixXd positions(m, 2);
  for (int i = 0; i < m; ++i) {
    const Vec2 x = picture.at(mesh.nodes[side_node(mesh, elem, side, i)]);
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
  path.move_to(picture.at(mesh.nodes[side_start(mesh, elem, 0)]));
  for (int side = 0; side < 4; ++side) append_curve(path, quad_side(picture, mesh, elem, side), 0, 1);
  path.close();
  return path;
}

}  // namespace quadrille::draw
