#include "triangulate/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/segments.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::triangulate {
namespace {

bool is_straight(const Nurbs& curve, double tol) {
  const Vec2 a = curve.poles.front(), chord = curve.poles.back() - a;
  const double length = norm(chord);
  if (length <= tol) return false;
  return std::all_of(curve.poles.begin(), curve.poles.end(), [&](Vec2 pole) {
    const double along = dot(chord, pole - a) / length;
    return std::abs(cross(chord, pole - a)) <= tol * length && along >= -tol && along <= length + tol;
  });
}

/// d curvature / d arc length, from the first three derivatives.
double curvature_slope(const Nurbs& curve, double t, bool from_left) {
  const auto d = curve::derivatives(curve, t, from_left);
  const double speed2 = norm2(d[1]);
  if (speed2 == 0) return 0;
  return (cross(d[1], d[3]) - 3 * cross(d[1], d[2]) * dot(d[1], d[2]) / speed2) / (speed2 * speed2);
}

double curvature_or_zero(const Nurbs& curve, double t, bool from_left) {
  return norm2(curve::derivatives(curve, t, from_left)[1]) == 0 ? 0 : curve::curvature(curve, t, from_left);
}

constexpr double sample_turn = radians(10.0);

void sample(const Nurbs& curve, double t0, double t1, Vec2 tangent0, Vec2 tangent1, int depth,
            std::vector<Vec2>& points) {
  constexpr int max_depth = 10;
  const double middle = (t0 + t1) / 2;
  const Vec2 between = curve::tangent(curve, middle);
  const auto turn = [](Vec2 a, Vec2 b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); };
  if (depth < max_depth && (depth < 2 || turn(tangent0, between) + turn(between, tangent1) > sample_turn)) {
    sample(curve, t0, middle, tangent0, between, depth + 1, points);
    sample(curve, middle, t1, between, tangent1, depth + 1, points);
  } else {
    points.push_back(curve::point(curve, t1));
  }
}

std::vector<Vec2> polyline(const Outline& outline, const SmoothPiece& piece) {
  const Nurbs& curve = outline.face().curves[piece.curve];
  std::vector<Vec2> points{curve::point(curve, piece.t0)};
  if (piece.is_straight) {
    points.push_back(curve::point(curve, piece.t1));
    return points;
  }
  std::vector<double> ends{piece.t0};
  for (const double knot : curve.knots)
    if (knot > ends.back() && knot < piece.t1) ends.push_back(knot);
  ends.push_back(piece.t1);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    sample(curve, ends[i], ends[i + 1], curve::tangent(curve, ends[i]), curve::tangent(curve, ends[i + 1], true), 0,
           points);
  return points;
}

/// Distance from `apex` to points[first], points[first + 1], ...
double distance_from(const std::vector<Vec2>& points, std::size_t first, Vec2 apex) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i + 1 < points.size(); ++i)
    least = std::min(least, distance_to_segment(apex, points[i], points[i + 1]));
  return least;
}

/// Distance from points[0] to the part of the polyline that approaches it again.
double return_distance(const std::vector<Vec2>& points) {
  std::size_t i = 0;
  while (i + 1 < points.size() && distance(points[0], points[i + 1]) >= distance(points[0], points[i])) ++i;
  return i + 1 < points.size() ? distance_from(points, i, points[0]) : std::numeric_limits<double>::infinity();
}

}  // namespace

Outline::Outline(const CadFace& face, double straight_tol) : face_(&face) {
  lengths_.reserve(face.curves.size());
  for (int c = 0; c < face.num_curves(); ++c) {
    lengths_.emplace_back(face.curves[c]);
    add_pieces(c, straight_tol);
  }
  link_loops();
  for (int p = 0; p < static_cast<int>(pieces_.size()); ++p) junctions_.push_back(junction(p));
  link_slits();
}

void Outline::add_pieces(int curve, double straight_tol) {
  const Nurbs& nurbs = face_->curves[curve];
  const bool straight = is_straight(nurbs, straight_tol);
  std::vector<double> ends{nurbs.begin()};
  if (!straight) {
    const auto breaks = curve::smoothness_breaks(nurbs);
    ends.insert(ends.end(), breaks.begin(), breaks.end());
  }
  ends.push_back(nurbs.end());
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double s0 = lengths_[curve].at(ends[i]), s1 = lengths_[curve].at(ends[i + 1]);
    pieces_.push_back({curve, ends[i], ends[i + 1], s0, s1, straight, 0, 0});
  }
}

void Outline::link_loops() {
  const int count = static_cast<int>(pieces_.size());
  int first = 0;
  for (int p = 0; p < count; ++p) {
    const bool is_last = p + 1 == count || face_->loop_of(pieces_[p + 1].curve) != face_->loop_of(pieces_[p].curve);
    const int next = is_last ? first : p + 1;
    pieces_[p].next = next;
    pieces_[next].previous = p;
    if (is_last) first = p + 1;
  }
}

// The pieces of a curve are those of its partner in the opposite order; where one of them starts, the other ends.
void Outline::link_slits() {
  const int count = static_cast<int>(pieces_.size());
  std::vector<int> first_piece(face_->num_curves() + 1, count);
  for (int p = count - 1; p >= 0; --p) first_piece[pieces_[p].curve] = p;
  DisjointSets places(count);
  for (int p = 0; p < count; ++p) {
    const int curve = pieces_[p].curve;
    if (!face_->is_interface(curve)) continue;
    const int partner = face_->partners[curve];
    const int pieces_of_partner = first_piece[partner + 1] - first_piece[partner];
    if (pieces_of_partner != first_piece[curve + 1] - first_piece[curve])
      throw Defect("the sides of a slit have different pieces");
    pieces_[p].partner = first_piece[partner] + pieces_of_partner - 1 - (p - first_piece[curve]);
    places.unite(p, pieces_[pieces_[p].partner].next);
  }
  for (int p = 0; p < count; ++p) junctions_[p].place = places.find(p);
}

double Outline::partner_parameter(int curve, double t) const {
  const Nurbs &own = face_->curves[curve], &other = face_->curves[face_->partners[curve]];
  if (t == own.begin()) return other.end();
  if (t == own.end()) return other.begin();
  return other.begin() + (own.end() - t);
}

Junction Outline::junction(int piece) const {
  const SmoothPiece& out = pieces_[piece];
  const SmoothPiece& in = pieces_[out.previous];
  const Nurbs& curve_out = face_->curves[out.curve];
  const Nurbs& curve_in = face_->curves[in.curve];
  const bool is_joint = out.t0 == curve_out.begin();
  Junction junction;
  junction.position = is_joint ? face_->joints[out.curve].position : curve::point(curve_out, out.t0);
  junction.interior_angle = is_joint ? face_->joints[out.curve].interior_angle : pi;
  const double quarters = junction.interior_angle / (pi / 2);
  // At corners of slits that are right, straight or full angles the data do not jump.
  junction.has_bridge =
      is_joint && face_->is_slit_joint(out.curve) && std::abs(quarters - std::round(quarters)) > tolerance::round_off;
  if (!in.is_straight) {
    junction.curvature_in = curvature_or_zero(curve_in, in.t1, true);
    junction.curvature_slope_in = curvature_slope(curve_in, in.t1, true);
  }
  if (!out.is_straight) {
    junction.curvature_out = curvature_or_zero(curve_out, out.t0, false);
    junction.curvature_slope_out = curvature_slope(curve_out, out.t0, false);
  }
  return junction;
}

Vec2 Outline::at(int curve, double t) const { return curve::point(face_->curves[curve], t); }

Clearance::Clearance(const Outline& outline) : outline_(&outline) {
  for (const SmoothPiece& piece : outline.pieces()) polylines_.push_back(polyline(outline, piece));
}

bool Clearance::ends_in(int piece, int place) const {
  const auto& junctions = outline_->junctions();
  return junctions[piece].place == place || junctions[outline_->pieces()[piece].next].place == place;
}

bool Clearance::is_closed(int piece) const {
  const auto& junctions = outline_->junctions();
  return junctions[piece].place == junctions[outline_->pieces()[piece].next].place;
}

double Clearance::at_junction(int j) const {
  const int in = outline_->pieces()[j].previous;
  const Vec2 apex = outline_->junctions()[j].position;
  auto arriving = polylines_[in];
  std::reverse(arriving.begin(), arriving.end());
  double least = std::numeric_limits<double>::infinity();
  if (!is_closed(j)) least = return_distance(polylines_[j]);
  if (!is_closed(in)) least = std::min(least, return_distance(arriving));
  for (int p = 0; p < static_cast<int>(polylines_.size()); ++p)
    if (!ends_in(p, outline_->junctions()[j].place)) least = std::min(least, distance_from(polylines_[p], 0, apex));
  return least;
}

}  // namespace quadrille::triangulate
