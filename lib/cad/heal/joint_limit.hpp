#pragma once
// How far healing may move the ends of two curves to their joint.

#include <vector>

#include "curve/pole_box.hpp"
#include "heal/measured_edge.hpp"

namespace quadrille::heal {

/// What sets the limit of a joint.
enum class LimitReason { tolerance, edge, clearance };

/// The ends of two consecutive edges, with how far they may move.
struct LimitedJoint {
  JointSide in, out;
  LimitReason reason = LimitReason::tolerance;  ///< of the lower limit
};

class JointLimit {
 public:
  /// `wires` must outlive the object. `tolerance`: greatest limit, a length.
  JointLimit(const std::vector<std::vector<RawEdge>>& wires, double tolerance);

  /// The limit of each end is the least of the tolerance, a tenth of its edge's length (a quarter if the end slides
  /// along a line), and a quarter of the distance of the joint from all edges that are not in `near`. `near`: the two
  /// edges themselves and their neighbours. Cost: a projection to each edge nearer than the limit.
  LimitedJoint joint(const MeasuredEdge& in, const MeasuredEdge& out, const std::vector<const RawEdge*>& near) const;

 private:
  double clearance(Vec2 x, const std::vector<const RawEdge*>& ignored, double most) const;

  struct BoxedEdge {
    const RawEdge* edge;
    curve::PoleBox box;
  };
  std::vector<BoxedEdge> edges_;
  double tolerance_;
};

}  // namespace quadrille::heal
