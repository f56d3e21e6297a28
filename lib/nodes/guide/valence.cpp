#include "guide/valence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "surface/positions.hpp"
#include "zeros/winding.hpp"

namespace quadrille::guide {
namespace {

/// The least extent of the two curves at a joint.
double least_extent(const CadFace& face, int joint) {
  const auto extent = [&](int curve) {
    const Nurbs& c = face.curves[curve];
    const Vec2 a = curve::point(c, c.begin()), m = curve::point(c, 0.5 * (c.begin() + c.end())),
               b = curve::point(c, c.end());
    return std::max(distance(a, m), distance(a, b));
  };
  return std::min(extent(joint), extent(face.previous_in_loop(joint)));
}

/// The value that |v| must exceed on an arc to be trusted. The error is that in the middle of the arc. If the angle is
/// off the tie, the chord misses 0 by twice as much, and the compensating zero must lie inside the arc.
double enough(const field::FieldEvaluator& evaluator, const Joint& joint, const zeros::Disc& disc, double noise) {
  const std::vector<double>& errors = evaluator.field().elem_error;
  const Vec2 middle = disc.centre + disc.radius * unit(joint.tangent_out + 0.5 * joint.interior_angle);
  const int elem = errors.empty() ? -1 : evaluator.locator().find(middle).elem;
  const double from_tie = 20 * tie_distance(joint.interior_angle);
  return std::max({10 * noise, from_tie, elem < 0 ? 0 : 3 * errors[elem]});
}

struct ArcValence {
  int valence = 0;
  double trust = 0;  ///< |v| on the arc relative to the value that it must exceed
};

/// Quads in the sector, from the turn of the phase on an arc from the outgoing to the incoming side.
std::optional<ArcValence> valence_by_arc(const field::FieldEvaluator& evaluator, const Joint& joint,
                                         const zeros::Disc& disc, double noise) {
  constexpr double margin = 0.05;  // for curved sides; the part outside the domain is ignored
  const auto turn = zeros::phase_turn(evaluator, disc.centre, disc.radius, joint.tangent_out - margin,
                                      joint.tangent_out + joint.interior_angle + margin);
  if (!turn || turn->least_value < 10 * noise) return {};
  // The cross at both ends is aligned with the sides: V is the number of quarter turns between them less the field's
  // own.
  return ArcValence{static_cast<int>(std::lround((4 * joint.interior_angle - turn->turn) / (2 * pi))),
                    turn->least_value / enough(evaluator, joint, disc, noise)};
}

/// The valence at a tie and the disc of the arc that decides it. At a tie |v| grows like (r / diameter)^(pi / omega):
/// the radii start at the value at which this is 1e-8, but not below the resolution of positions, and are doubled.
std::optional<int> valence_at_tie(const field::FieldEvaluator& evaluator, int joint, double noise, zeros::Disc& disc) {
  const CadFace& face = evaluator.field().mesh.face;
  const Joint& corner = face.joints[joint];
  const double greatest = 0.2 * least_extent(face, joint);
  const double least = std::max(tolerance::round_off, std::pow(10.0, -8 * corner.interior_angle / pi));
  ArcValence best;
  for (double radius = least * face.diameter; radius <= greatest && best.trust < 1; radius *= 2) {
    const zeros::Disc arc{corner.position, radius};
    const auto here = valence_by_arc(evaluator, corner, arc, noise);
    if (here && here->trust > best.trust) best = *here, disc = arc;
  }
  if (best.trust == 0) return {};
  return best.valence;
}

[[noreturn]] void refuse(const Joint& joint, const CadFace& face) {
  throw ComputeError(fmt::format("the guiding field does not decide the valence of the corner of {:.6g} degrees at {}",
                                 degrees(joint.interior_angle), surface::position_text(face, joint.position)));
}

}  // namespace

double tie_distance(double interior_angle) {
  const double quarters = interior_angle / half_pi;
  return std::abs(quarters - std::floor(quarters) - 0.5) * half_pi;
}

CornerValences corner_valences_by_angle(const CadFace& face) {
  CornerValences result;
  for (int j = 0; j < face.num_curves(); ++j) {
    const Joint& joint = face.joints[j];
    if (!joint.is_corner) continue;
    const int valence = static_cast<int>(std::lround(joint.interior_angle / half_pi));
    result.corners.push_back(
        {j, joint.position, degrees(joint.interior_angle), valence, {face.previous_in_loop(j), j}, NodeSource::angle});
  }
  return result;
}

CornerValences corner_valences(const field::FieldEvaluator& evaluator, double noise) {
  const CadFace& face = evaluator.field().mesh.face;
  CornerValences result = corner_valences_by_angle(face);
  for (Corner& corner : result.corners) {
    if (tie_distance(face.joints[corner.joint].interior_angle) >= tolerance::same_angle) continue;
    zeros::Disc disc;
    const auto by_arc = valence_at_tie(evaluator, corner.joint, noise, disc);
    if (!by_arc) refuse(face.joints[corner.joint], face);
    result.discs.push_back(disc);
    corner.valence = *by_arc;
    corner.source = NodeSource::field;
  }
  return result;
}

bool is_admissible_valence(double angle_degrees, int valence) {
  if (valence == 0) return true;
  const double block = angle_degrees / valence;
  return valence > 0 && valence <= greatest_corner_valence && block <= greatest_block_angle + tolerance::tied &&
         (valence == 1 || block >= least_block_angle - tolerance::tied);
}

bool is_admissible_after_absorption(double angle_degrees, int valence) {
  if (valence == 0) return std::abs(angle_degrees - 45) < degrees(near_tie);
  const double block = angle_degrees / valence;
  return valence > 0 && valence <= greatest_corner_valence && block >= least_block_angle &&
         block <= greatest_block_angle && std::abs(valence - angle_degrees / 90) <= 0.75;
}

int index_sum_with_clusters(const CriticalPoints& points) {
  int sum = index_sum_of(points);
  for (const Cluster& cluster : points.clusters) sum += cluster.index;
  return sum;
}

void require_index_sum(const CriticalPoints& points, const CadFace& face) {
  const int excess = points.index_sum - points.index_sum_expected;
  if (excess == 0) return;
  std::string message = fmt::format(
      "the sum of 4 - V over {} critical points and of 2 - V over {} corners is {}, but it must be {} for this face: "
      "{} too {}",
      points.critical_points.size(), points.corners.size(), points.index_sum, points.index_sum_expected,
      std::abs(excess), excess > 0 ? "many" : "few");
  const auto from_tie = [](const Corner& c) { return degrees(tie_distance(radians(c.angle_degrees))); };
  const auto nearest = std::min_element(points.corners.begin(), points.corners.end(),
                                        [&](const Corner& a, const Corner& b) { return from_tie(a) < from_tie(b); });
  if (nearest != points.corners.end()) {
    message += fmt::format("; the least certain corner is the one of {:.6g} degrees at {}, valence {}",
                           nearest->angle_degrees, surface::position_text(face, nearest->position), nearest->valence);
  }
  throw ComputeError(message);
}

}  // namespace quadrille::guide
