#pragma once
// The curved parts of a boundary loop: longest runs, over smooth joints, that are curved to one side everywhere.

#include <vector>

#include "features/loop_section.hpp"

namespace quadrille::features {

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
