#include "guide/valence.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "guide/winding.hpp"

namespace quadrille {
namespace {

/// The least extent of the two curves at a joint.
double room(const CadFace& face, int joint) {
  const auto extent = [&](int curve) {
    const Nurbs& c = face.curves[curve];
    const Vec2 a = point(c, c.begin()), m = point(c, 0.5 * (c.begin() + c.end())), b = point(c, c.end());
    return std::max(distance(a, m), distance(a, b));
  };
  return std::min(extent(joint), extent(face.previous_in_loop(joint)));
}

/// Quads in the sector, from the turn of the phase on an arc from the outgoing to the incoming side.
int valence_by_arc(const FieldEvaluator& evaluator, int joint) {
  const CadFace& face = evaluator.field().mesh.face;
  const Joint& corner = face.joints[joint];
  const Disc disc = tie_disc(face, joint);
  const double margin = 0.05;
  const auto turn = phase_turn(evaluator, disc.centre, disc.radius, corner.tangent_out - margin,
                               corner.tangent_out + corner.interior_angle + margin);
  if (!turn || turn->least_value < field_noise) {
    const Vec2 x = corner.position + face.origin;
    throw ComputeError(
        fmt::format("the guiding field does not decide the valence of the corner of {:.6g} degrees at "
                    "({:.6g}, {:.6g})",
                    degrees(corner.interior_angle), x.x, x.y));
  }
  // The cross at both ends lies along the sides: the sector holds the quarter turns between them less the field's own.
  return static_cast<int>(std::lround((4 * corner.interior_angle - turn->turn) / (2 * pi)));
}

}  // namespace

double tie_distance(double interior_angle) {
  const double quarters = interior_angle / half_pi;
  return std::abs(quarters - std::floor(quarters) - 0.5) * half_pi;
}

Disc tie_disc(const CadFace& face, int joint) {
  // On the disc's rim the field, of size (r / diameter)^(pi / omega), must stand out of its errors.
  const double rim = std::pow(10.0, -7 * face.joints[joint].interior_angle / pi);
  return {face.joints[joint].position, std::min(std::max(2e-3, rim) * face.diameter, 0.2 * room(face, joint))};
}

std::vector<Corner> corner_valences(const FieldEvaluator& evaluator) {
  const CadFace& face = evaluator.field().mesh.face;
  std::vector<Corner> corners;
  for (int j = 0; j < face.num_curves(); ++j) {
    const Joint& joint = face.joints[j];
    if (!joint.is_corner) continue;
    const int valence = is_tie(joint.interior_angle) ? valence_by_arc(evaluator, j)
                                                     : static_cast<int>(std::lround(joint.interior_angle / half_pi));
    corners.push_back({j, joint.position, degrees(joint.interior_angle), valence, {face.previous_in_loop(j), j}});
  }
  return corners;
}

}  // namespace quadrille
