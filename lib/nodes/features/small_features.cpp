#include "features/small_features.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "features/curved_runs.hpp"
#include "features/feature_constants.hpp"

namespace quadrille::features {
namespace {

/// The run that contains the bend: the one around the middle of the bend's first interval.
const CurvedRun& run_around(const std::vector<CurvedRun>& runs, const CurvedRun& bend) {
  const CurveInterval& first = bend.parts.front().interval;
  const double middle = (first.t0 + first.t1) / 2;
  for (const CurvedRun& run : runs) {
    for (const CurvedInterval& part : run.parts) {
      if (part.interval.curve == first.curve && part.interval.t0 <= middle && middle <= part.interval.t1) return run;
    }
  }
  return bend;
}

FeatureKind kind_of(const CurvedRun& run) {
  return run.side() == TurnSide::left ? FeatureKind::convex : FeatureKind::reflex;
}

std::vector<CurvedRun> all_runs(const CadFace& face, int loop) {
  return curved_runs(face, loop, feature_constants.straight_curvature / face.diameter);
}

/// The largest distance between two sample points of a loop, or any distance above `enough` as soon as it is found.
double diameter_of(const CadFace& face, int loop, double enough) {
  std::vector<Vec2> points;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    for (const double t : sample_parameters(face.curves[c])) points.push_back(curve::point(face.curves[c], t));
  }
  double largest = 0;
  for (const Vec2 a : points) {
    for (const Vec2 b : points) largest = std::max(largest, distance(a, b));
    if (largest > enough) break;
  }
  return largest;
}

int hole_capacity(const CadFace& face, int loop) {
  int sum = 4;
  for (int j = face.loop_offsets[loop]; j < face.loop_offsets[loop + 1]; ++j) {
    const Joint& joint = face.joints[j];
    if (joint.is_corner) sum += 2 - static_cast<int>(std::lround(joint.interior_angle / half_pi));
  }
  return std::max(sum, 0);
}

/// Adds the bends of a loop below `size`; the bends of a hole that is one small run all round are part of the hole.
void add_bends(const CadFace& face, int loop, double size, bool is_small_hole, std::vector<SmallFeature>& bends) {
  const std::vector<CurvedRun> runs = all_runs(face, loop);
  for (const CurvedRun& bend : curved_runs(face, loop, 1 / size)) {
    const CurvedRun& run = run_around(runs, bend);
    const int capacity = index_capacity_of(run.turning());
    if (bend.is_loop || (is_small_hole && run.is_loop) || capacity == 0) continue;
    bends.push_back({kind_of(bend), LoopSection(face, bend.intervals(), false),
                     LoopSection(face, run.intervals(), run.is_loop), bend.least_radius(), capacity});
  }
}

}  // namespace

int index_capacity_of(double turning) {
  return static_cast<int>(std::floor(turning / half_pi + feature_constants.index_rounding));
}

std::vector<SmallFeature> small_features(const CadFace& face, double size) {
  const double below = size * (1 - tolerance::tied);
  std::vector<SmallFeature> features, holes;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    const double extent = loop == 0 ? face.diameter : diameter_of(face, loop, below);
    const bool is_small_hole = loop > 0 && extent < below;
    add_bends(face, loop, below, is_small_hole, features);
    if (!is_small_hole) continue;
    const LoopSection whole = whole_loop(face, loop);
    holes.push_back({FeatureKind::hole, whole, whole, extent, hole_capacity(face, loop)});
  }
  features.insert(features.end(), holes.begin(), holes.end());
  return features;
}

std::vector<SmallFeature> runs_of_any_size(const CadFace& face) {
  std::vector<SmallFeature> features;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    for (const CurvedRun& run : all_runs(face, loop)) {
      const int capacity = index_capacity_of(run.turning());
      if (capacity == 0 || (loop == 0 && run.is_loop)) continue;
      const LoopSection section(face, run.intervals(), run.is_loop);
      features.push_back(
          {run.is_loop ? FeatureKind::hole : kind_of(run), section, section, run.least_radius(), capacity});
    }
  }
  return features;
}

}  // namespace quadrille::features
