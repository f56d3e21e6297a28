#include "page/space_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "draw/draw_in_space.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::page {

namespace {

constexpr int fine_mesh = 5000;  ///< elements: sides of more are straight

std::string json_vector(Vec3 x) { return fmt::format("[{:.17g},{:.17g},{:.17g}]", x.x, x.y, x.z); }

/// The points of all outlines, one after the other: `per_side` of each side, without its end.
std::vector<Vec3> outlines(const QuadMesh& mesh, int per_side) {
  std::vector<double> at;
  for (int i = 0; i < per_side; ++i) at.push_back(-1 + 2.0 * i / per_side);
  const Eigen::MatrixXd to_samples = spectral::interpolation_matrix(spectral::gll_points(mesh.order), at);
  std::vector<Vec3> points;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> ids = side_nodes(mesh, elem, side);
      for (int i = 0; i < per_side; ++i) {
        Vec3 x;
        for (int k = 0; k <= mesh.order; ++k) x += to_samples(i, k) * mesh.space_nodes[ids[k]];
        points.push_back(x);
      }
    }
  return points;
}

}  // namespace

JsonObject space_data(const QuadMesh& mesh) {
  const int per_side = mesh.order == 1 || mesh.num_elems() > fine_mesh ? 1 : 4;
  const std::vector<Vec3> points = outlines(mesh, per_side);
  Vec3 low = points.front(), high = low;
  for (const Vec3 x : points) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  const Vec3 middle = (low + high) / 2;
  std::vector<double> coordinates;
  double radius = 0;
  for (const Vec3 x : points) {
    const Vec3 own = x - middle;
    coordinates.insert(coordinates.end(), {own.x, own.y, own.z});
    radius = std::max(radius, norm(own));
  }
  const draw::SpaceView view = draw::space_view(mesh, {});
  JsonObject object;
  object.data("points", packed_floats(coordinates)).number("samples", 4 * per_side).number("extent", 2 * radius);
  object.json("right", json_vector(view.right)).json("up", json_vector(view.up));
  return object.json("towards", json_vector(view.towards));
}

}  // namespace quadrille::page
