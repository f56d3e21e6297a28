#include "field/phase_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle_sum.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "surface/positions.hpp"

namespace quadrille::field {
namespace {

// Angles differ from a piece's references by less than acos(0.1) < pi / 2.
constexpr double least_cosine = 0.1;

double extent(const Nurbs& piece) {
  double most = 0;
  for (const Vec2 pole : piece.poles) most = std::max(most, distance(pole, piece.poles.front()));
  return most;
}

bool is_within(Vec2 a, Vec2 axis, double axis_length) { return dot(a, axis) >= least_cosine * norm(a) * axis_length; }

Vec2 middle_of_ends(const Nurbs& piece) { return (piece.poles.front() + piece.poles.back()) / 2; }

// The tangents of a curve with positive weights lie in the cone of the differences of its poles: B-splines are totally
// positive, so (sum w N P)' sum w N - ... is a positive combination of P_j - P_i, i < j.
bool tangents_are_near_chord(const Nurbs& piece) {
  const Vec2 chord = piece.poles.back() - piece.poles.front();
  if (chord == Vec2{}) return false;
  const double length = norm(chord);
  for (std::size_t i = 1; i < piece.poles.size(); ++i) {
    if (!is_within(piece.poles[i] - piece.poles[i - 1], chord, length)) return false;
  }
  return true;
}

// The curve lies in the hull of its poles.
bool is_seen_within_a_quarter_turn(const Nurbs& piece, const TurnCentre& from) {
  const Vec2 axis = middle_of_ends(piece) - from.position;
  if (axis == Vec2{}) return false;
  const double length = norm(axis);
  return std::all_of(piece.poles.begin(), piece.poles.end(),
                     [&](Vec2 pole) { return from.is_at(pole) || is_within(pole - from.position, axis, length); });
}

bool has_references(const Nurbs& piece, const std::vector<TurnCentre>& centres) {
  return tangents_are_near_chord(piece) && std::all_of(centres.begin(), centres.end(), [&](const TurnCentre& centre) {
           return is_seen_within_a_quarter_turn(piece, centre);
         });
}

[[noreturn]] void refuse(const CadFace& face, const Nurbs& piece) {
  const std::string position = surface::position_text(face, piece.poles.front());
  if (!tangents_are_near_chord(piece)) throw ComputeError("the boundary has a cusp near " + position);
  throw ComputeError(fmt::format("the irregular node near {} is on the boundary; it must be inside", position));
}

void follow_piece(const CadFace& face, const std::vector<TurnCentre>& centres, const Nurbs& piece, LoopAngles& angles,
                  std::vector<AnglePiece>& pieces) {
  if (!has_references(piece, centres)) {
    const double middle = (piece.begin() + piece.end()) / 2;
    // A centre whose distance from the boundary is round-off lies on the boundary.
    if (extent(piece) <= tolerance::round_off * face.diameter || middle <= piece.begin() || middle >= piece.end())
      refuse(face, piece);
    follow_piece(face, centres, curve::trimmed(piece, piece.begin(), middle), angles, pieces);
    follow_piece(face, centres, curve::trimmed(piece, middle, piece.end()), angles, pieces);
    return;
  }
  AnglePiece p{piece.begin(), piece.end(), {0, angles.corner_index, {}}, {}};
  p.reference.tangent = nearest_branch(angles.tangent, angle_of(piece.poles.back() - piece.poles.front()));
  const Vec2 tangent = curve::tangent(piece, piece.end(), true);
  angles.tangent = nearest_branch(p.reference.tangent, angle_of(tangent));
  for (std::size_t i = 0; i < centres.size(); ++i) {
    p.axes.push_back(middle_of_ends(piece) - centres[i].position);
    p.reference.centres.push_back(nearest_branch(angles.centres[i], angle_of(p.axes.back())));
    angles.centres[i] = nearest_branch(p.reference.centres[i], angle_of(centres[i].to(piece.poles.back(), -tangent)));
  }
  pieces.push_back(std::move(p));
}

// The sums of turns times the angle from the axis of the piece to the point, for at most AngleSums::width points. The
// lanes beyond the last point repeat it.
AngleSums sums_of_differences(const AnglePiece& piece, const std::vector<TurnCentre>& centres,
                              std::span<const Vec2> points) {
  AngleSums::Values x, y, along, across;
  for (std::size_t lane = 0; lane < x.size(); ++lane) {
    const Vec2 point = points[std::min(lane, points.size() - 1)];
    x[lane] = point.x;
    y[lane] = point.y;
  }
  AngleSums sums;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    if (centres[i].turns == 0) continue;
    const Vec2 centre = centres[i].position, axis = piece.axes[i];
    for (std::size_t lane = 0; lane < x.size(); ++lane) {
      const Vec2 r{x[lane] - centre.x, y[lane] - centre.y};
      along[lane] = dot(axis, r);
      across[lane] = cross(axis, r);
    }
    sums.add(along, across, centres[i].turns);
  }
  return sums;
}

// Greatest gap of the data (radians) that is attributed to round-off and omitted jumps.
constexpr double closure_tol = 1e-7;

}  // namespace

void AnglePiece::sums_of_turns(const std::vector<TurnCentre>& centres, std::span<const Vec2> x, double* sums) const {
  double references = 0;
  for (std::size_t i = 0; i < centres.size(); ++i)
    if (centres[i].turns != 0) references += centres[i].turns * reference.centres[i];
  for (std::size_t first = 0; first < x.size(); first += AngleSums::width) {
    const std::span<const Vec2> few = x.subspan(first, std::min<std::size_t>(AngleSums::width, x.size() - first));
    const AngleSums differences = sums_of_differences(*this, centres, few);
    for (std::size_t i = 0; i < few.size(); ++i) sums[first + i] = references + differences.value(static_cast<int>(i));
  }
}

LoopAngles angles_at_start(const CadFace& face, const std::vector<TurnCentre>& centres, int loop) {
  const Nurbs& curve = face.curves[face.loop_offsets[loop]];
  const Vec2 x = curve::point(curve, curve.begin());
  const Vec2 tangent = curve::tangent(curve, curve.begin());
  LoopAngles start{angle_of(tangent), 0, {}};
  for (const TurnCentre& centre : centres) start.centres.push_back(angle_of(centre.to(x, tangent)));
  return start;
}

void follow_angles(const CadFace& face, const std::vector<TurnCentre>& centres, int curve, double t0, double t1,
                   LoopAngles& angles, std::vector<AnglePiece>& pieces) {
  follow_piece(face, centres, curve::trimmed(face.curves[curve], t0, t1), angles, pieces);
  // Not the tangent of the trimmed curve, whose last poles nearly coincide where t1 is close to a knot.
  angles.tangent = nearest_branch(angles.tangent, angle_of(curve::tangent(face.curves[curve], t1, true)));
}

const AnglePiece& piece_at(const std::vector<AnglePiece>& pieces, double t, bool from_left) {
  return *std::partition_point(pieces.begin(), pieces.end() - 1,
                               [&](const AnglePiece& p) { return from_left ? p.t1 < t : p.t1 <= t; });
}

int round_to_turns(double angle) { return static_cast<int>(std::lround(angle / (2 * pi))); }

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
  // A centre in the apex sees the domain's sector pass, from the incoming side to the outgoing one.
  const std::vector<TurnCentre>& centres = loops_[loop].followed();
  for (std::size_t i = 0; i < centres.size(); ++i)
    if (centres[i].is_at(x)) angles.centres[i] = nearest_branch(angles.centres[i] - apex.interior_angle, angle_of(out));
  apex_remainders_[a] = data(loop, x, angles, sum_of_corner_angles(explicit_.terms.corner_angles, x, corner, out));
  const double jump = apex_remainders_[a] - incoming;
  if (apex.is_enclosed) {
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
    const std::string position = surface::position_text(*face_, centre.position);
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

std::vector<ApexTurn> PhaseBoundary::apex_turns() const {
  std::vector<ApexTurn> turns;
  const PhaseTerms& terms = explicit_.terms;
  for (std::size_t a = 0; a < apexes().apexes.size(); ++a) {
    const BoundaryApex& apex = apexes().apexes[a];
    const Vec2 x = curve::point(face_->curves[apex.curve], apex.t);
    double own = 0;  // turns about the apex for each radian
    if (const int corner = corners_->terms().apex2corner_angle[a]; corner >= 0) own = terms.corner_angles[corner].beta;
    for (const TurnCentre& centre : explicit_.centres)
      if (centre.is_at(x)) own += centre.turns;
    const double turn = apex_jumps_[a] - own * apex.interior_angle / 2;
    if (turn != 0) turns.push_back({x, turn});
  }
  return turns;
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
