#include "triangulate/junction_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angle.hpp"
#include "base/segments.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::triangulate {
namespace {

constexpr double sample_turn = radians(10.0);
constexpr int max_depth = 10;

void sample(const Nurbs& curve, double t0, double t1, Vec2 tangent0, Vec2 tangent1, int depth,
            std::vector<Vec2>& points) {
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
