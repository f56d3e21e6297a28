#include "field/followed_angles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle_sum.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::field {
namespace {

// A centre whose distance from the boundary is below this fraction of the diameter lies on the boundary.
constexpr double on_boundary_tol = 1e-9;
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
bool is_seen_within_a_quarter_turn(const Nurbs& piece, Vec2 from) {
  const Vec2 axis = middle_of_ends(piece) - from;
  if (axis == Vec2{}) return false;
  const double length = norm(axis);
  return std::all_of(piece.poles.begin(), piece.poles.end(),
                     [&](Vec2 pole) { return is_within(pole - from, axis, length); });
}

bool has_references(const Nurbs& piece, const std::vector<TurnCentre>& centres) {
  return tangents_are_near_chord(piece) && std::all_of(centres.begin(), centres.end(), [&](const TurnCentre& centre) {
           return is_seen_within_a_quarter_turn(piece, centre.position);
         });
}

[[noreturn]] void refuse(const CadFace& face, const Nurbs& piece) {
  const std::string position = position_text(piece.poles.front() + face.origin);
  if (!tangents_are_near_chord(piece)) throw ComputeError("the boundary has a cusp near " + position);
  throw ComputeError(fmt::format("the irregular node near {} is on the boundary; it must be inside", position));
}

void follow_piece(const CadFace& face, const std::vector<TurnCentre>& centres, const Nurbs& piece, LoopAngles& angles,
                  std::vector<AnglePiece>& pieces) {
  if (!has_references(piece, centres)) {
    const double middle = (piece.begin() + piece.end()) / 2;
    if (extent(piece) <= on_boundary_tol * face.diameter || middle <= piece.begin() || middle >= piece.end())
      refuse(face, piece);
    follow_piece(face, centres, curve::trimmed(piece, piece.begin(), middle), angles, pieces);
    follow_piece(face, centres, curve::trimmed(piece, middle, piece.end()), angles, pieces);
    return;
  }
  AnglePiece p{piece.begin(), piece.end(), {0, angles.corner_index, {}}, {}};
  p.reference.tangent = nearest_branch(angles.tangent, angle_of(piece.poles.back() - piece.poles.front()));
  angles.tangent = nearest_branch(p.reference.tangent, angle_of(curve::tangent(piece, piece.end(), true)));
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Vec2 from = centres[i].position;
    p.axes.push_back(middle_of_ends(piece) - from);
    p.reference.centres.push_back(nearest_branch(angles.centres[i], angle_of(p.axes.back())));
    angles.centres[i] = nearest_branch(p.reference.centres[i], angle_of(piece.poles.back() - from));
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
  LoopAngles start{angle_of(curve::tangent(curve, curve.begin())), 0, {}};
  for (const TurnCentre& centre : centres) start.centres.push_back(angle_of(x - centre.position));
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

}  // namespace quadrille::field
