#pragma once
// The point at which two consecutive curves are made to meet, and how far healing may move
// their ends to it, and the curves with these ends.

#include <optional>
#include <vector>

#include "curve/pole_box.hpp"
#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"

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

/// The curve from `start` to `end`, in one piece or more. A line stays a line. An arc is first made longer or shorter
/// on its circle; then any curve is mapped by the one similarity that takes its ends to the new ones: an arc stays an
/// arc, and no tangent turns by more than the distance moved over the chord. A curve whose chord is short against its
/// reach (an arc above 300 degrees, a closed curve) is cut in its middle, which does not move. End poles are exactly
/// `start` and `end`.
std::vector<Nurbs> moved_curve(const Nurbs& curve, Vec2 start, Vec2 end);

}  // namespace quadrille::heal
