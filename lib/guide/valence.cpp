#include "guide/valence.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "guide/winding.hpp"

namespace quadrille {
namespace {

constexpr double near_tie = 0.02, tie = 1e-6;  // radians

/// The least extent of the two curves at a joint.
double room(const CadFace& face, int joint) {
  const auto extent = [&](int curve) {
    const Nurbs& c = face.curves[curve];
    const Vec2 a = point(c, c.begin()), m = point(c, 0.5 * (c.begin() + c.end())), b = point(c, c.end());
    return std::max(distance(a, m), distance(a, b));
  };
  return std::min(extent(joint), extent(face.previous_in_loop(joint)));
}

/// Where the corner's arc runs: on it the field, of size (r / diameter)^(pi / omega), must stand out of its errors.
Disc corner_disc(const CadFace& face, int joint) {
  const double rim = std::pow(10.0, -7 * face.joints[joint].interior_angle / pi);
  return {face.joints[joint].position, std::min(std::max(2e-3, rim) * face.diameter, 0.2 * room(face, joint))};
}

/// Quads in the sector, from the turn of the phase on an arc from the outgoing to the incoming side.
std::optional<int> valence_by_arc(const FieldEvaluator& evaluator, const Joint& joint, const Disc& disc) {
  constexpr double margin = 0.05;  // curved sides: what lies outside the domain is left out
  const auto turn = phase_turn(evaluator, disc.centre, disc.radius, joint.tangent_out - margin,
                               joint.tangent_out + joint.interior_angle + margin);
  if (!turn || turn->least_value < field_noise) return {};
  // The cross at both ends lies along the sides: the sector holds the quarter turns between them less the field's own.
  return static_cast<int>(std::lround((4 * joint.interior_angle - turn->turn) / (2 * pi)));
}

[[noreturn]] void refuse(const Joint& joint, Vec2 origin) {
  const Vec2 x = joint.position + origin;
  throw ComputeError(
      fmt::format("the guiding field does not decide the valence of the corner of {:.6g} degrees at ({:.6g}, {:.6g})",
                  degrees(joint.interior_angle), x.x, x.y));
}

}  // namespace

double tie_distance(double interior_angle) {
  const double quarters = interior_angle / half_pi;
  return std::abs(quarters - std::floor(quarters) - 0.5) * half_pi;
}

CornerValences corner_valences(const FieldEvaluator& evaluator) {
  const CadFace& face = evaluator.field().mesh.face;
  CornerValences result;
  for (int j = 0; j < face.num_curves(); ++j) {
    const Joint& joint = face.joints[j];
    if (!joint.is_corner) continue;
    int valence = static_cast<int>(std::lround(joint.interior_angle / half_pi));
    const double doubt = tie_distance(joint.interior_angle);
    if (doubt < near_tie) {
      const Disc disc = corner_disc(face, j);
      const auto by_arc = valence_by_arc(evaluator, joint, disc);
      if (!by_arc && doubt < tie) refuse(joint, face.origin);
      if (by_arc) result.discs.push_back(disc);
      valence = by_arc.value_or(valence);
    }
    result.corners.push_back(
        {j, joint.position, degrees(joint.interior_angle), valence, {face.previous_in_loop(j), j}});
  }
  return result;
}

}  // namespace quadrille
