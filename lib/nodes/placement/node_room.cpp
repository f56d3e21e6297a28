#include "placement/node_room.hpp"

#include <algorithm>

#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "curve/project.hpp"

namespace quadrille::placement {
namespace {

constexpr double greatest_step = 0.5;  // of the distance to the nearest obstacle
constexpr double kept_fraction = 0.5;  // of distances to other nodes and to boundaries without layers

/// The nodes to which each of the moving nodes may come too near.
void find_neighbours(const CriticalPoints& points, std::vector<MovingNode>& moving) {
  std::vector<const MovingNode*> by_node(points.critical_points.size(), nullptr);
  for (const MovingNode& node : moving) by_node[node.node] = &node;
  for (MovingNode& node : moving)
    for (int j = 0; j < static_cast<int>(by_node.size()); ++j) {
      if (j == node.node) continue;
      const double other_reach = by_node[j] ? by_node[j]->reach : 0;
      const double d = distance(points.critical_points[j].position, node.start);
      const double least = kept_fraction * d;
      if (d - least < node.reach + other_reach) node.neighbours.push_back({j, least, by_node[j] != nullptr});
    }
}

}  // namespace

WallSurroundings::WallSurroundings(const CadFace& face, const std::vector<WallClearance>& walls)
    : face_(face),
      boxes_(curve::pole_boxes(face.curves)),
      clearance_(clearance_of_curves(face, walls)),
      mean_width_(curve::mean_width(face)) {}

MissedClearance WallSurroundings::missed(Vec2 x) const {
  MissedClearance result;
  for (int c = 0; c < face_.num_curves(); ++c) {
    const double enough = clearance_[c] * (1 - tolerance::tied);
    if (boxes_[c].distance_from(x) >= enough) continue;
    const double r = curve::project(face_.curves[c], x).distance;
    if (r >= enough) continue;
    if (clearance_[c] - r > result.shortfall) result.curve = c, result.shortfall = clearance_[c] - r;
    result.greatest = std::max(result.greatest, clearance_[c]);
  }
  return result;
}

std::vector<MovingNode> WallSurroundings::moving_nodes(const std::vector<bool>& may_move,
                                                       const CriticalPoints& points) const {
  std::vector<MovingNode> moving;
  for (std::size_t k = 0; k < may_move.size(); ++k) {
    const Vec2 start = points.critical_points[k].position;
    const MissedClearance missed = may_move[k] ? this->missed(start) : MissedClearance();
    if (missed.curve < 0) continue;
    moving.push_back({static_cast<int>(k), start, missed.greatest, std::min(missed.shortfall, mean_width_), {}, {}});
    moving.back().obstacles = obstacles(moving.back());
  }
  find_neighbours(points, moving);
  return moving;
}

std::vector<Obstacle> WallSurroundings::obstacles(const MovingNode& moving) const {
  std::vector<Obstacle> found;
  for (int c = 0; c < face_.num_curves(); ++c) {
    const double least = std::max(std::min(clearance_[c], mean_width_), moving.reach);
    if (boxes_[c].distance_from(moving.start) < least + moving.reach) add_parts(c, moving, found);
  }
  return found;
}

/// Each knot span has a nearest point of its own, so that a curve which surrounds the node does so from all sides.
void WallSurroundings::add_parts(int curve, const MovingNode& moving, std::vector<Obstacle>& found) const {
  const std::vector<double>& knots = face_.curves[curve].knots;
  const bool is_wall = clearance_[curve] > 0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i - 1] >= knots[i]) continue;
    const double r = curve::project(face_.curves[curve], moving.start, knots[i - 1], knots[i]).distance;
    const double least = is_wall ? std::min(clearance_[curve], mean_width_) : kept_fraction * r;
    if (r < least + moving.reach) found.push_back({curve, knots[i - 1], knots[i], least, is_wall});
  }
}

/// Without those that no point within the reach misses.
NodeRoom WallSurroundings::room(const MovingNode& moving, const CriticalPoints& points) const {
  const Vec2 x = points.critical_points[moving.node].position;
  const double farthest = moving.reach + distance(moving.start, x);
  NodeRoom room;
  for (const Obstacle& o : moving.obstacles) {
    if (boxes_[o.curve].distance_from(x) > o.least + farthest) continue;
    const curve::Projection foot = curve::project(face_.curves[o.curve], x, o.t0, o.t1);
    room.longest_step = std::min(room.longest_step, greatest_step * foot.distance);
    if (foot.distance <= o.least + farthest)
      room.planes.push_back({(x - foot.position) / foot.distance, o.least - foot.distance, o.is_wall});
  }
  for (const Neighbour& other : moving.neighbours) {
    const Vec2 between = x - points.critical_points[other.node].position;
    const double d = norm(between), bound = (other.least - d) * (other.moves ? 0.5 : 1);
    if (bound >= -farthest) room.planes.push_back({between / d, bound, false});
  }
  return room;
}

}  // namespace quadrille::placement
