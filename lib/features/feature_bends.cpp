#include "features/feature_bends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::features {
namespace {

constexpr int samples_per_span = 24;
constexpr double equal = 1e-6;
constexpr double flat = 1e-3;  // curvature x diameter below which a wall counts as straight

/// Where a curve is curved to one side (+1 left, -1 right) more than a limit; `turning` >= 0.
struct Bent {
  CurvePart part;
  int side = 0;
  double turning = 0, greatest_curvature = 0;
};

/// A chain of them over smooth joints.
struct Chain {
  std::vector<Bent> parts;
  bool is_loop = false;

  int side() const { return parts.front().side; }
  double turning() const {
    double sum = 0;
    for (const Bent& bent : parts) sum += bent.turning;
    return sum;
  }
  double radius() const {
    double k = 0;
    for (const Bent& bent : parts) k = std::max(k, bent.greatest_curvature);
    return 1 / k;
  }
};

std::vector<double> sample_parameters(const Nurbs& curve) {
  std::vector<double> t{curve.begin()};
  for (size_t i = 1; i < curve.knots.size(); ++i) {
    const double a = curve.knots[i - 1], b = curve.knots[i];
    for (int j = 1; a < b && j <= samples_per_span; ++j) t.push_back(a + (b - a) * j / samples_per_span);
  }
  t.back() = curve.end();
  return t;
}

/// The middle of a sample interval decides for it: curvature may jump at its ends.
int side_at(const Nurbs& curve, double t, double limit) {
  const double k = curve::curvature(curve, t);
  return std::abs(k) > limit ? (k > 0 ? 1 : -1) : 0;
}

/// Where the side changes between a and b.
double change_between(const Nurbs& curve, double a, double b, double limit) {
  const int side = side_at(curve, a, limit);
  for (int i = 0; i < 60; ++i) {
    const double m = (a + b) / 2;
    (side_at(curve, m, limit) == side ? a : b) = m;
  }
  return (a + b) / 2;
}

double turn_between(const Nurbs& curve, double a, double b) {
  return std::abs(wrap_pi(angle_of(curve::tangent(curve, b, true)) - angle_of(curve::tangent(curve, a))));
}

void measure(const Nurbs& curve, const std::vector<double>& samples, Bent& bent) {
  double last = bent.part.t0;
  const auto advance = [&](double t) {
    bent.turning += turn_between(curve, last, t);
    bent.greatest_curvature =
        std::max({bent.greatest_curvature, std::abs(curve::curvature(curve, (last + t) / 2)),
                  std::abs(curve::curvature(curve, last)), std::abs(curve::curvature(curve, t, true))});
    last = t;
  };
  for (const double t : samples) {
    if (t > last && t < bent.part.t1) advance(t);
  }
  advance(bent.part.t1);
}

std::vector<Bent> bent_parts(const Nurbs& curve, int id, double limit) {
  const std::vector<double> samples = sample_parameters(curve);
  std::vector<Bent> parts;
  int side = 0;
  double previous = curve.begin();
  for (size_t i = 1; i < samples.size(); ++i) {
    const double middle = (samples[i - 1] + samples[i]) / 2;
    const int here = side_at(curve, middle, limit);
    if (here != side) {
      const double change = i == 1 ? curve.begin() : change_between(curve, previous, middle, limit);
      if (side != 0) parts.back().part.t1 = change;
      if (here != 0) parts.push_back({{id, change, curve.end()}, here});
    }
    side = here;
    previous = middle;
  }
  for (Bent& bent : parts) measure(curve, samples, bent);
  return parts;
}

bool follows(const CadFace& face, const Bent& a, const Bent& b) {
  return a.side == b.side && a.part.t1 == face.curves[a.part.curve].end() &&
         b.part.t0 == face.curves[b.part.curve].begin() && face.next_in_loop(a.part.curve) == b.part.curve &&
         !face.joints[b.part.curve].is_corner;
}

/// Of one loop; `limit` in 1 / length.
std::vector<Chain> chains(const CadFace& face, int loop, double limit) {
  std::vector<Chain> result;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    for (const Bent& bent : bent_parts(face.curves[c], c, limit)) {
      if (!result.empty() && follows(face, result.back().parts.back(), bent))
        result.back().parts.push_back(bent);
      else
        result.push_back({{bent}});
    }
  }
  if (result.empty() || !follows(face, result.back().parts.back(), result.front().parts.front())) return result;
  if (result.size() == 1) {
    result.front().is_loop = true;
  } else {
    std::vector<Bent>& first = result.front().parts;
    first.insert(first.begin(), result.back().parts.begin(), result.back().parts.end());
    result.pop_back();
  }
  return result;
}

const Chain& run_of(const std::vector<Chain>& runs, const Chain& bend) {
  const CurvePart& part = bend.parts.front().part;
  const double middle = (part.t0 + part.t1) / 2;
  for (const Chain& run : runs) {
    for (const Bent& b : run.parts) {
      if (b.part.curve == part.curve && b.part.t0 <= middle && middle <= b.part.t1) return run;
    }
  }
  return bend;
}

int carried(double turning) { return static_cast<int>(std::floor(turning / half_pi + 0.6)); }

FeatureKind kind_of(const Chain& chain) { return chain.side() > 0 ? FeatureKind::convex : FeatureKind::reflex; }

std::vector<CurvePart> parts_of(const Chain& chain) {
  std::vector<CurvePart> parts;
  for (const Bent& bent : chain.parts) parts.push_back(bent.part);
  return parts;
}

std::vector<Vec2> points_of(const CadFace& face, int loop) {
  std::vector<Vec2> points;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    for (const double t : sample_parameters(face.curves[c])) points.push_back(curve::point(face.curves[c], t));
  }
  return points;
}

/// The largest distance between two points, or some distance above `enough`.
double diameter_of(const std::vector<Vec2>& points, double enough) {
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

SmallFeature hole(const CadFace& face, int loop, double extent) {
  std::vector<CurvePart> parts;
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c)
    parts.push_back({c, face.curves[c].begin(), face.curves[c].end()});
  const Stretch whole(face, std::move(parts), true);
  return {FeatureKind::hole, whole, whole, extent, hole_capacity(face, loop)};
}

}  // namespace

std::vector<SmallFeature> small_features(const CadFace& face, double size) {
  const double below = size * (1 - equal);
  std::vector<SmallFeature> bends, holes;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    const std::vector<Chain> runs = chains(face, loop, flat / face.diameter);
    const double extent = loop == 0 ? face.diameter : diameter_of(points_of(face, loop), below);
    const bool is_small_hole = loop > 0 && extent < below;
    for (const Chain& bend : chains(face, loop, 1 / below)) {
      const Chain& run = run_of(runs, bend);
      if (bend.is_loop || (is_small_hole && run.is_loop)) continue;
      if (carried(run.turning()) > 0)
        bends.push_back({kind_of(bend), Stretch(face, parts_of(bend), false), Stretch(face, parts_of(run), run.is_loop),
                         bend.radius(), carried(run.turning())});
    }
    if (is_small_hole) holes.push_back(hole(face, loop, extent));
  }
  bends.insert(bends.end(), holes.begin(), holes.end());
  return bends;
}

std::vector<SmallFeature> runs_of_any_size(const CadFace& face) {
  std::vector<SmallFeature> features;
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    for (const Chain& run : chains(face, loop, flat / face.diameter)) {
      if (carried(run.turning()) == 0 || (loop == 0 && run.is_loop)) continue;
      const Stretch stretch(face, parts_of(run), run.is_loop);
      features.push_back(
          {run.is_loop ? FeatureKind::hole : kind_of(run), stretch, stretch, run.radius(), carried(run.turning())});
    }
  }
  return features;
}

}  // namespace quadrille::features
