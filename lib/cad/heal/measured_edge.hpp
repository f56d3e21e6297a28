#pragma once
// An edge with what the rules of healing ask about it.

#include <vector>

#include "heal/joint_target.hpp"
#include "heal/raw_face.hpp"

namespace quadrille::heal {

struct MeasuredEdge {
  const RawEdge* raw = nullptr;
  curve::Carrier carrier;
  Rank rank = Rank::spline;
  double length = 0;
};

/// The edges of all wires; pointers into `wires`.
std::vector<std::vector<MeasuredEdge>> measured(const std::vector<std::vector<RawEdge>>& wires);

/// The end of an edge at a joint, or its start, without limits of its movement (see JointLimit).
JointSide end_of(const MeasuredEdge& edge);
JointSide start_of(const MeasuredEdge& edge);

}  // namespace quadrille::heal
