#pragma once
// A section of a boundary loop in the direction of the loop, parametrised by the fraction in [0, 1] of its length;
// and the curved sections: longest runs, over smooth joints, that are curved to one side everywhere.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::features {

/// From t0 to t1 > t0 on a curve of the face.
struct CurveInterval {
  int curve = 0;
  double t0 = 0, t1 = 0;
};

/// A point of the boundary. At the joint of two curves it is the start of the second.
struct SectionPoint {
  int curve = 0;
  double t = 0;
  Vec2 position;
};

/// The point of a section nearest to a given point of the plane.
struct SectionFoot {
  double fraction = 0;  ///< relative to the section's length
  double distance = 0;
  Vec2 position;
};

class LoopSection {
 public:
  /// Each interval starts at the end of the one before; `face` must outlive the section. `is_closed`: a whole loop.
  LoopSection(const CadFace& face, std::vector<CurveInterval> intervals, bool is_closed);

  double length() const { return ends_.back(); }
  bool is_closed() const { return is_closed_; }
  const std::vector<CurveInterval>& intervals() const { return intervals_; }
  /// The point at a fraction of the length; a fraction outside [0, 1] is clamped, or wrapped if the section is closed.
  /// A parameter within 1e-9 of the curve's range from a knot or end is moved to the knot or the joint.
  SectionPoint at(double fraction) const;
  /// The nearest point. Linear in the number of intervals.
  SectionFoot foot(Vec2 x) const;

 private:
  const CadFace* face_;
  std::vector<CurveInterval> intervals_;
  bool is_closed_;
  std::vector<double> ends_;  ///< length up to the end of each interval
};

/// Loop `loop` of the face as one closed section.
LoopSection whole_loop(const CadFace& face, int loop);

/// Whether the two sections have a part of the boundary in common; common end points do not count.
bool do_overlap(const LoopSection& a, const LoopSection& b);

/// The side to which the boundary turns, with the face on its left.
enum class TurnSide { left, right, none };

/// An interval of one curve that is curved to one side.
struct CurvedInterval {
  CurveInterval interval;
  TurnSide side = TurnSide::none;
  double turning = 0;  ///< radians, >= 0: angle between the tangents at its ends
  double greatest_curvature = 0;
};

/// Consecutive curved intervals, connected by smooth joints, all curved to one side.
struct CurvedRun {
  std::vector<CurvedInterval> parts;
  bool is_loop = false;  ///< the run is a whole loop

  TurnSide side() const { return parts.front().side; }
  double turning() const;
  double least_radius() const;
  std::vector<CurveInterval> intervals() const;
};

/// The longest runs of a loop on which |curvature| exceeds `least_curvature` (1 / length), in the order of the loop.
/// Curvature is sampled in the middle of equal parts of each knot span (FeatureConstants::samples_per_span), because it
/// may jump at knots; the ends of a run are found by bisection.
std::vector<CurvedRun> curved_runs(const CadFace& face, int loop, double least_curvature);

/// The parameters between which curvature is sampled on a curve: both ends of every part.
std::vector<double> sample_parameters(const Nurbs& curve);

}  // namespace quadrille::features
