#pragma once
// What surrounds the irregular nodes that move away from walls (placement/keep_clearance): boundary curves and other
// nodes to which they keep a distance.

#include <cmath>
#include <vector>

#include "curve/pole_box.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"
#include "placement/half_planes.hpp"
#include "placement/wall_clearance.hpp"

namespace quadrille::placement {

/// The clearances that a point misses, by more than 1e-6 of them.
struct MissedClearance {
  int curve = -1;        ///< the one that it misses by most; -1: it keeps all
  double shortfall = 0;  ///< by which it misses that one
  double greatest = 0;   ///< of the clearances that it misses
};

/// Part of a curve to which a node keeps a distance of `least`.
struct Obstacle {
  int curve = 0;
  double t0 = 0, t1 = 0;
  double least = 0;
  bool is_wall = false;
};

/// Another node to which a node keeps a distance of `least`.
struct Neighbour {
  int node = 0;
  double least = 0;
  bool moves = false;
};

struct MovingNode {
  int node = 0;
  Vec2 start;
  double clearance = 0;  ///< the greatest that it misses at the start
  double reach = 0;      ///< the greatest distance from the start: the greatest shortfall there
  std::vector<Obstacle> obstacles;
  std::vector<Neighbour> neighbours;
};

/// The half planes of the steps with which a node keeps its distances, to first order.
struct NodeRoom {
  std::vector<HalfPlane> planes;
  double longest_step = HUGE_VAL;  ///< half of the distance to the nearest obstacle
};

/// Clearances above the mean width of the face count as that much. Stores a reference to the face. Positions are
/// relative to face.origin, lengths in the file's unit.
class WallSurroundings {
 public:
  WallSurroundings(const CadFace& face, const std::vector<WallClearance>& walls);

  double clearance(int curve) const { return clearance_[curve]; }
  MissedClearance missed(Vec2 x) const;
  /// The nodes with may_move[k] that miss a clearance, each with what it may come too near to within its reach.
  std::vector<MovingNode> moving_nodes(const std::vector<bool>& may_move, const CriticalPoints& points) const;
  /// The room of a node at its position of `points`. Two nodes that move share what is between them.
  NodeRoom room(const MovingNode& moving, const CriticalPoints& points) const;

 private:
  std::vector<Obstacle> obstacles(const MovingNode& moving) const;
  void add_parts(int curve, const MovingNode& moving, std::vector<Obstacle>& found) const;

  const CadFace& face_;
  std::vector<curve::PoleBox> boxes_;
  std::vector<double> clearance_;  ///< by curve; 0: no wall
  double mean_width_;
};

}  // namespace quadrille::placement
