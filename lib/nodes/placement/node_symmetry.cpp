#include "placement/node_symmetry.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/tolerance.hpp"
#include "curve/symmetry.hpp"

namespace quadrille::placement {
namespace {

Mat2 linear_part(const curve::Isometry& isometry) {
  const Vec2 u = unit(isometry.angle);
  return isometry.is_mirrored ? Mat2{u.x, u.y, u.y, -u.x} : Mat2{u.x, -u.y, u.y, u.x};
}

struct FreeNode {
  Vec2 position;
  int valence;
  bool is_free;
};

const auto same_valence = [](const auto& a, const auto& b) { return a.valence == b.valence; };

bool keeps_boundary(const CriticalPoints& points, const curve::Isometry& isometry, double tol) {
  return curve::images(points.corners, isometry, tol, same_valence).size() == points.corners.size() &&
         curve::images(points.boundary_nodes, isometry, tol, same_valence).size() == points.boundary_nodes.size();
}

// Whether the group contains, with g and h, the isometry g h, judged by the images of the nodes.
bool is_closed(const std::vector<NodeSymmetry>& group) {
  for (const NodeSymmetry& g : group)
    for (const NodeSymmetry& h : group) {
      const Mat2 gh = g.linear * h.linear;
      const bool is_there = std::any_of(group.begin(), group.end(), [&](const NodeSymmetry& k) {
        const Mat2 l = k.linear;
        if (std::hypot(std::hypot(l.xx - gh.xx, l.xy - gh.xy), std::hypot(l.yx - gh.yx, l.yy - gh.yy)) >
            tolerance::same_angle)
          return false;
        for (std::size_t i = 0; i < k.image.size(); ++i)
          if (k.image[i] != g.image[h.image[i]]) return false;
        return true;
      });
      if (!is_there) return false;
    }
  return true;
}

bool has_winding_offsets(const CriticalPoints& points) {
  return std::any_of(points.hole_winding_offsets.begin(), points.hole_winding_offsets.end(),
                     [](int m) { return m != 0; });
}

double distance_to_next(const SmoothBoundaryDistance& boundary, const CriticalPoints& points, int node) {
  const Vec2 x = points.critical_points[node].position;
  double next = boundary.nearest(x).distance;
  for (std::size_t j = 0; j < points.critical_points.size(); ++j)
    if (static_cast<int>(j) != node) next = std::min(next, distance(points.critical_points[j].position, x));
  return next;
}

}  // namespace

std::vector<NodeSymmetry> node_symmetries(const CadFace& face, const CriticalPoints& points,
                                          const std::vector<bool>& is_free) {
  std::vector<FreeNode> nodes;
  for (std::size_t k = 0; k < is_free.size(); ++k)
    nodes.push_back({points.critical_points[k].position, points.critical_points[k].valence, is_free[k]});
  const double tol = tolerance::same_point * face.diameter;
  const auto is_same = [](const FreeNode& a, const FreeNode& b) {
    return a.valence == b.valence && a.is_free == b.is_free;
  };
  std::vector<NodeSymmetry> group;
  for (const curve::Isometry& isometry :
       has_winding_offsets(points) ? std::vector{curve::Isometry{}} : curve::symmetries(face)) {
    const std::vector<int> image = curve::images(nodes, isometry, tol, is_same);
    if (image.size() != nodes.size() || !keeps_boundary(points, isometry, tol)) continue;
    group.push_back({isometry, linear_part(isometry), image});
  }
  if (!is_closed(group)) group.resize(1);
  return group;
}

void symmetrise(const std::vector<NodeSymmetry>& group, const std::vector<bool>& is_free, CriticalPoints& points) {
  std::vector<Vec2> sum(is_free.size());
  for (const NodeSymmetry& g : group)
    for (std::size_t k = 0; k < g.image.size(); ++k) sum[g.image[k]] += g.isometry(points.critical_points[k].position);
  for (std::size_t k = 0; k < is_free.size(); ++k)
    if (is_free[k]) points.critical_points[k].position = sum[k] / static_cast<double>(group.size());
}

Eigen::MatrixXd invariant_movements(const std::vector<NodeSymmetry>& group, const std::vector<bool>& is_free) {
  std::vector<int> row(is_free.size(), -1);
  int num_free = 0;
  for (std::size_t k = 0; k < is_free.size(); ++k)
    if (is_free[k]) row[k] = 2 * num_free++;
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(2 * num_free, 2 * num_free);
  for (const NodeSymmetry& g : group)
    for (std::size_t k = 0; k < is_free.size(); ++k) {
      if (!is_free[k]) continue;
      Eigen::Matrix2d linear;
      linear << g.linear.xx, g.linear.xy, g.linear.yx, g.linear.yy;
      mean.block<2, 2>(row[g.image[k]], row[k]) += linear / static_cast<double>(group.size());
    }
  // The mean is a projector: eigenvalues 0 and 1, in ascending order.
  if (group.size() == 1) return mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(mean);
  const auto num_invariant = (modes.eigenvalues().array() > 0.5).count();
  return modes.eigenvectors().rightCols(num_invariant);
}

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
