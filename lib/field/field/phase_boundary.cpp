#include "field/phase_boundary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::field {

namespace {

// Greatest gap of the data (radians) that is attributed to round-off and omitted jumps.
constexpr double closure_tol = 1e-7;

}  // namespace

PhaseBoundary::PhaseBoundary(const CadFace& face, const PhaseNodes& prescribed)
    : PhaseBoundary(face, prescribed, std::make_shared<SharedCorners>(face, prescribed)) {}

PhaseBoundary::PhaseBoundary(const CadFace& face, const PhaseNodes& prescribed, std::shared_ptr<SharedCorners> corners)
    : face_(&face),
      corners_(std::move(corners)),
      explicit_(explicit_terms(*corners_, prescribed.nodes)),
      apex_remainders_(apexes().apexes.size(), 0.0),
      apex_jumps_(apexes().apexes.size(), 0.0),
      pieces_(face.num_curves()) {
  require_valence_sum(face, prescribed);
  for (int loop = 0; loop < face.num_loops(); ++loop) {
    loops_.emplace_back(face, loop, explicit_.centres);
    follow_loop(loop);
  }
}

PhaseBoundary::PhaseBoundary(const TriMesh& mesh, const PhaseNodes& prescribed, std::shared_ptr<SharedCorners> corners)
    : PhaseBoundary(mesh.face, prescribed, std::move(corners)) {
  bridges_.emplace(mesh);
}

void PhaseBoundary::follow_loop(int loop) {
  const std::vector<TurnCentre>& centres = loops_[loop].followed();
  const int first = face_->loop_offsets[loop], last = face_->loop_offsets[loop + 1];
  const LoopAngles start = angles_at_start(*face_, centres, loop);
  LoopAngles angles = start;
  for (int a = apexes().offsets[first]; a < apexes().offsets[last]; ++a) {
    if (a > apexes().offsets[first]) pass_apex(loop, a, angles);
    const BoundaryApex& apex = apexes().apexes[a];
    const bool is_last = a + 1 == apexes().offsets[apex.curve + 1];
    const double t1 = is_last ? face_->curves[apex.curve].end() : apexes().apexes[a + 1].t;
    follow_angles(*face_, centres, apex.curve, apex.t, t1, angles, pieces_[apex.curve]);
  }
  pass_apex(loop, apexes().offsets[first], angles);
  require_inside(loop, start, angles);
  require_closure(loop, start, angles);
}

// g from the continuous angles at a point x and the sum of beta_c theta_c at that point.
double PhaseBoundary::data(int loop, Vec2 x, const LoopAngles& angles, double corner_angles) const {
  double value = 4 * angles.tangent - 2 * pi * angles.corner_index - corner_angles - loops_[loop].sum_of_far(x);
  const std::vector<TurnCentre>& centres = loops_[loop].followed();
  for (std::size_t i = 0; i < centres.size(); ++i) value -= centres[i].turns * angles.centres[i];
  return value;
}

// Computes g at the apex from the outgoing side; the incoming side must agree.
void PhaseBoundary::pass_apex(int loop, int a, LoopAngles& angles) {
  const BoundaryApex& apex = apexes().apexes[a];
  const Vec2 x = curve::point(face_->curves[apex.curve], apex.t);
  const auto [in, out] = tangents_at(*face_, apex);
  const int corner = corners_->terms().apex2corner_angle[a];
  const double incoming = data(loop, x, angles, sum_of_corner_angles(explicit_.terms.corner_angles, x, corner, -in));
  angles.tangent = nearest_branch(angles.tangent + pi - apex.interior_angle, angle_of(out));
  angles.corner_index += 2 - apex.valence;
  apex_remainders_[a] = data(loop, x, angles, sum_of_corner_angles(explicit_.terms.corner_angles, x, corner, out));
  const double jump = apex_remainders_[a] - incoming;
  if (face_->is_slit_joint(apex.curve) && apex.t == face_->curves[apex.curve].begin()) {
    apex_jumps_[a] = jump;
    apex_remainders_[a] -= jump / 2;
    return;
  }
  if (std::abs(jump) > closure_tol) throw Defect(fmt::format("phase data jump by {} at joint {}", jump, apex.curve));
}

void PhaseBoundary::require_inside(int loop, const LoopAngles& start, const LoopAngles& end) const {
  const std::vector<TurnCentre>& centres = loops_[loop].followed();
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const TurnCentre& centre = centres[i];
    if (round_to_turns(end.centres[i] - start.centres[i]) == centre.winding_number(loop)) continue;
    const std::string position = position_text(centre.position + face_->origin);
    if (centre.loop >= 0) throw Defect(position + " was taken for a point outside the face");
    throw ComputeError(
        fmt::format("the irregular node at {} is {}", position, loop == 0 ? "outside the face" : "in a hole"));
  }
}

// Checks in integers that g changes by no whole turn around the loop, as the index sum and the turns D_j of the holes
// imply.
void PhaseBoundary::require_closure(int loop, const LoopAngles& start, const LoopAngles& end) const {
  int turns = 4 * round_to_turns(end.tangent - start.tangent) - end.corner_index;
  const std::vector<TurnCentre>& centres = loops_[loop].followed();
  for (std::size_t i = 0; i < centres.size(); ++i)
    turns -= centres[i].turns * round_to_turns(end.centres[i] - start.centres[i]);
  if (turns != 0) throw Defect(fmt::format("phase data of loop {} do not close: {} turns", loop, turns));
}

std::vector<double> PhaseBoundary::interior_angles() const {
  std::vector<double> angles(explicit_.terms.corner_angles.size());
  for (std::size_t a = 0; a < apexes().apexes.size(); ++a) {
    if (const int corner = corners_->terms().apex2corner_angle[a]; corner >= 0)
      angles[corner] = apexes().apexes[a].interior_angle;
  }
  return angles;
}

double PhaseBoundary::phase(int curve, double t) const {
  const Nurbs& nurbs = face_->curves[curve];
  const bool from_left = t >= nurbs.end();
  const LoopAngles& reference = piece_at(pieces_[curve], t, from_left).reference;
  return 4 * nearest_branch(reference.tangent, angle_of(curve::tangent(nurbs, t, from_left))) -
         2 * pi * reference.corner_index;
}

double PhaseBoundary::remainder(int curve, double t) const {
  double value = 0;
  remainders(curve, {&t, 1}, &value);
  return value;
}

void PhaseBoundary::remainders(int curve, std::span<const double> t, double* values) const {
  const BoundarySamples& samples = corners_->samples(curve, t);
  const LoopCentres& centres = loops_[face_->loop_of(curve)];
  for (std::size_t first = 0; first < t.size();) {
    const AnglePiece& piece = piece_at(pieces_[curve], t[first], false);
    std::size_t last = first + 1;
    while (last < t.size() && t[last] < piece.t1 && t[last] >= piece.t0) ++last;
    piece.sums_of_turns(centres.followed(), std::span(samples.x).subspan(first, last - first), values + first);
    for (std::size_t i = first; i < last; ++i) {
      const double phase = 4 * nearest_branch(piece.reference.tangent, samples.tangent_angles[i]) -
                           2 * pi * piece.reference.corner_index;
      const int apex = samples.apexes[i];
      values[i] = apex >= 0 ? apex_remainders_[apex]
                            : phase - samples.corner_angles[i] - centres.sum_of_far(samples.x[i]) - values[i];
    }
    first = last;
  }
  if (bridges_) bridge(curve, t, values);
}

// The data of a curve start half a jump above the mean at its joint and end half a jump below that at the next one.
void PhaseBoundary::bridge(int curve, std::span<const double> t, double* values) const {
  for (std::size_t i = 0; i < t.size(); ++i) {
    const auto at = bridges_->at(curve, t[i]);
    if (!at || at->share == 0) continue;
    const double jump = apex_jumps_[apexes().offsets[at->joint]];
    values[i] += (1 - at->share) * (at->joint == curve ? -jump / 2 : jump / 2);
  }
}

}  // namespace quadrille::field
