#include "placement/reduced_coordinates.hpp"

#include <algorithm>

namespace quadrille::placement {
namespace {

double distance_to_next(const SmoothBoundaryDistance& boundary, const CriticalPoints& points, int node) {
  const Vec2 x = points.critical_points[node].position;
  double next = boundary.nearest(x);
  for (std::size_t j = 0; j < points.critical_points.size(); ++j)
    if (static_cast<int>(j) != node) next = std::min(next, distance(points.critical_points[j].position, x));
  return next;
}

}  // namespace

std::vector<Vec2> ReducedCoordinates::movement(const Eigen::VectorXd& y) const {
  const Eigen::VectorXd scaled = movements * y;
  std::vector<Vec2> moves(scales.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(2 * i);
    moves[free[i]] = scales[free[i]] * Vec2{scaled[row], scaled[row + 1]};
  }
  return moves;
}

CriticalPoints ReducedCoordinates::moved(const CriticalPoints& base, const Eigen::VectorXd& y) const {
  CriticalPoints points = base;
  const std::vector<Vec2> moves = movement(y);
  for (const int k : free) points.critical_points[k].position += moves[k];
  return points;
}

Eigen::VectorXd ReducedCoordinates::gradient(const std::vector<Vec2>& by_nodes) const {
  Eigen::VectorXd scaled(2 * free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    const Vec2 g = scales[free[i]] * by_nodes[free[i]];
    scaled.segment<2>(static_cast<Eigen::Index>(2 * i)) << g.x, g.y;
  }
  return movements.transpose() * scaled;
}

std::vector<double> length_scales(const SmoothBoundaryDistance& boundary, const CriticalPoints& points,
                                  const std::vector<int>& free, const std::vector<NodeSymmetry>& group) {
  const std::size_t num_nodes = points.critical_points.size();
  std::vector<double> own(num_nodes), mean(num_nodes, 0.0);
  for (const int k : free) own[k] = distance_to_next(boundary, points, k);
  for (const NodeSymmetry& g : group)
    for (const int k : free) mean[g.image[k]] += own[k] / static_cast<double>(group.size());
  return mean;
}

}  // namespace quadrille::placement
