#include "triangulate/outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "base/vec2.hpp"
#include "curve/nurbs.hpp"
#include "model/interfaces.hpp"

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
  const std::vector<double> ends = span_ends(curve, piece.t0, piece.t1);
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

struct SingularityConstants {
  double far_field_tol = 1e-10;
  /// Greatest amplitude of a term r^2 log r over the edge of an element: at order 20 the error is then below 1e-8, for
  /// two such ends and with what other elements transmit. Measured on splines through 120, 500 and 2000 points of a
  /// coast: of the elements, 0, 5 and 18 miss that; with 0.2, 16, 125 and 220 do.
  double resolved_amplitude = 0.08;
  /// Fan factor used to decide which of two terms needs more layers.
  double usual_factor = 0.15;
};
constexpr SingularityConstants singularity_constants;

/// The jump of the second derivative of the field's phase, 4 times the tangent's angle, along the boundary.
double phase_bend_jump(const Junction& j) { return 4 * std::abs(j.curvature_slope_out - j.curvature_slope_in); }

Singularity curvature_jump(const Junction& j, double radius) {
  const double jump = 4 * std::abs(j.curvature_out - j.curvature_in) * radius;
  const double slope_jump = phase_bend_jump(j) * radius * radius;
  const Singularity first{1, std::min(1.0, jump)}, second{2, std::min(1.0, slope_jump)};
  return fan_layers(first, singularity_constants.usual_factor) >= fan_layers(second, singularity_constants.usual_factor)
             ? first
             : second;
}

}  // namespace

std::vector<double> span_ends(const Nurbs& curve, double t0, double t1) {
  std::vector<double> ends{t0};
  for (const double knot : curve.knots)
    if (knot > ends.back() && knot < t1) ends.push_back(knot);
  ends.push_back(t1);
  return ends;
}

Outline::Outline(const CadFace& face, double straight_tol) : face_(&face) {
  lengths_.reserve(face.curves.size());
  for (int c = 0; c < face.num_curves(); ++c) {
    lengths_.emplace_back(face.curves[c]);
    add_pieces(c, straight_tol);
  }
  link_loops();
  const std::vector<bool> are_enclosed = enclosed_joints(face);
  for (int p = 0; p < static_cast<int>(pieces_.size()); ++p) junctions_.push_back(junction(p, are_enclosed));
  link_slits();
  link_places();
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

// The pieces of a curve are those of its partner in the opposite order.
void Outline::link_slits() {
  const int count = static_cast<int>(pieces_.size());
  std::vector<int> first_piece(face_->num_curves() + 1, count);
  for (int p = count - 1; p >= 0; --p) first_piece[pieces_[p].curve] = p;
  for (int p = 0; p < count; ++p) {
    const int curve = pieces_[p].curve;
    if (!face_->is_interface(curve)) continue;
    const int partner = face_->partners[curve];
    const int pieces_of_partner = first_piece[partner + 1] - first_piece[partner];
    if (pieces_of_partner != first_piece[curve + 1] - first_piece[curve])
      throw Defect("the sides of a slit have different pieces");
    pieces_[p].partner = first_piece[partner] + pieces_of_partner - 1 - (p - first_piece[curve]);
  }
}

// Where one of two partners starts, the other one ends; where a region touches itself, its loop is there twice.
void Outline::link_places() {
  const int count = static_cast<int>(pieces_.size());
  DisjointSets places(count);
  for (int p = 0; p < count; ++p)
    if (pieces_[p].partner >= 0) places.unite(p, pieces_[pieces_[p].partner].next);
  for (int first = 0, next; first < count; first = next) {
    std::vector<Vec2> positions;
    const int loop = face_->loop_of(pieces_[first].curve);
    for (next = first; next < count && face_->loop_of(pieces_[next].curve) == loop; ++next)
      positions.push_back(junctions_[next].position);
    const std::vector<int> in_loop = places_of(positions, tolerance::round_off * face_->diameter);
    for (std::size_t i = 0; i < in_loop.size(); ++i) places.unite(first + static_cast<int>(i), first + in_loop[i]);
  }
  for (int p = 0; p < count; ++p) junctions_[p].place = places.find(p);
}

double Outline::partner_parameter(int curve, double t) const {
  const Nurbs &own = face_->curves[curve], &other = face_->curves[face_->partners[curve]];
  if (t == own.begin()) return other.end();
  if (t == own.end()) return other.begin();
  return other.begin() + (own.end() - t);
}

Junction Outline::junction(int piece, const std::vector<bool>& are_enclosed) const {
  const SmoothPiece& out = pieces_[piece];
  const SmoothPiece& in = pieces_[out.previous];
  const Nurbs& curve_out = face_->curves[out.curve];
  const Nurbs& curve_in = face_->curves[in.curve];
  const bool is_joint = out.t0 == curve_out.begin();
  Junction junction;
  junction.position = is_joint ? face_->joints[out.curve].position : curve::point(curve_out, out.t0);
  junction.interior_angle = is_joint ? face_->joints[out.curve].interior_angle : pi;
  const double quarters = junction.interior_angle / (pi / 2);
  // At right, straight or full angles the data do not jump.
  junction.has_bridge =
      is_joint && are_enclosed[out.curve] && std::abs(quarters - std::round(quarters)) > tolerance::round_off;
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

Singularity junction_singularity(const Junction& junction, double radius) {
  if (junction.has_bridge) return {pi / junction.interior_angle, 1, 1};
  const double exponent = pi / junction.interior_angle, nearest = std::round(exponent);
  const double deviation = std::abs(exponent - nearest);
  // Smaller deviations from an integer are rounding errors of the file; near one the singular term is weak: its
  // amplitude vanishes with the deviation.
  const Singularity angular{exponent, deviation <= tolerance::tied ? 0 : std::min(1.0, 10 * deviation)};
  if (nearest < 1 || deviation >= 0.1) return angular;
  const auto bend_of = [radius](double curvature, double slope) {
    return 4 * (std::abs(curvature) + std::abs(slope) * radius) * radius;
  };
  const double bend = std::max(bend_of(junction.curvature_in, junction.curvature_slope_in),
                               bend_of(junction.curvature_out, junction.curvature_slope_out));
  const Singularity curved =
      nearest == 1 ? curvature_jump(junction, radius) : Singularity{nearest, std::min(1.0, bend)};
  return fan_layers(angular, singularity_constants.usual_factor) >=
                 fan_layers(curved, singularity_constants.usual_factor)
             ? angular
             : curved;
}

int fan_layers(const Singularity& singularity, double factor) {
  const auto [exponent, amplitude, apex_order] = singularity;
  if (exponent <= 0 || amplitude <= 0) return 0;
  const double left = amplitude * amplitude * std::pow(apex_order, -4 * exponent);
  if (left < singularity_constants.far_field_tol) return 0;
  const double layers = std::log(singularity_constants.far_field_tol / left) / (2 * exponent * std::log(factor));
  return std::max(1, static_cast<int>(std::lround(layers)));
}

double greatest_edge_length(const Junction& junction) {
  const double jump = phase_bend_jump(junction);
  const bool is_straight = std::lround(pi / junction.interior_angle) == 1;
  return is_straight && jump > 0 ? std::sqrt(singularity_constants.resolved_amplitude / jump)
                                 : std::numeric_limits<double>::infinity();
}

}  // namespace quadrille::triangulate
