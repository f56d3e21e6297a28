#pragma once
// The point at which two consecutive curves are made to meet.

#include <optional>
#include <vector>

#include "curve/carrier.hpp"

namespace quadrille::heal {

/// What yields first: splines, then arcs, then lines; a kept line does not turn.
enum class Rank { spline, arc, line, kept_line };

/// The ranks of all curves of a face. A line is kept if it lies at a multiple of 15 degrees, or is parallel to another.
std::vector<Rank> ranks_of(const std::vector<curve::Carrier>& carriers);

/// The end of a curve at a joint.
struct JointSide {
  curve::Carrier carrier;
  Rank rank = Rank::spline;
  Vec2 end;
  Vec2 tangent;             ///< unit, in either direction
  double most = 0;          ///< how far the end may move
  double most_sliding = 0;  ///< how far it may move along its line
};

/// The least tolerance, a length, with which joint_target finds a point if nothing but the tolerance limits both ends:
/// the gap between them, or what two lines that keep their directions need to slide to their intersection.
double needed_tolerance(const JointSide& a, const JointSide& b);

/// The first of these points to which both ends may move:
///
/// | curves                 | angle        | point                                                        |
/// |------------------------|--------------|--------------------------------------------------------------|
/// | two of line and arc    | > 1 degree   | their intersection nearest to the middle of the gap          |
/// | a line and an arc      | <= 1 degree  | foot of the arc's centre on the line                         |
/// | any                    |              | middle of the gap, moved to the line or circle of the curve  |
/// |                        |              | with the higher rank                                         |
/// | any                    |              | end of the curve that may move less                          |
///
/// Two kept lines that meet at more than 1 degree have their intersection only. std::nullopt if there is no point.
std::optional<Vec2> joint_target(const JointSide& a, const JointSide& b);

}  // namespace quadrille::heal
