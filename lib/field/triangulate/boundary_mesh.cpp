#include "triangulate/boundary_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "model/repair.hpp"
#include "surface/positions.hpp"
#include "triangulate/outline.hpp"
#include "triangulate/triangle_sizes.hpp"

namespace quadrille::triangulate {
namespace {

constexpr double slack = 1 + tolerance::round_off;
/// At order 8 each bisection reduces the error by a factor of 500; low orders do not reach 1e-12 with a reasonable
/// number of elements.
constexpr int max_fit_depth_high = 12, max_fit_depth_low = 1, high_order = 7;
constexpr int max_turn_depth = 30;
/// Touching curves would need infinitely many segments; curves at a relative distance of 1e-6 need some thousands.
/// They end at wedges with straight sides of 0.005 degrees, and at crescents with tips of 0.1 degrees.
constexpr std::size_t max_segments = 10000;

/// The inner knot of the segment, of continuity C3 or more, nearest to its middle. High derivatives jump there, so that
/// polynomials converge slowly on both sides together. std::nullopt if there is none, or two are equally near.
std::optional<SplitPoint> inner_knot(const Nurbs& curve, const curve::ArcLength& length, const Segment& segment) {
  std::optional<SplitPoint> nearest;
  double least = 0.4 * segment.length();  // farther from both ends than a tenth of the length
  const auto first = std::upper_bound(curve.knots.begin(), curve.knots.end(), segment.t0);
  for (auto knot = first; knot != curve.knots.end() && *knot < segment.t1;) {
    const auto next = std::upper_bound(knot, curve.knots.end(), *knot);
    if (next - knot <= curve.degree - 3) {
      const SplitPoint at{*knot, length.at(*knot)};
      const double off = std::abs(at.s - (segment.s0 + segment.s1) / 2), same = 1e-6 * segment.length();
      if (off < least + same) nearest = off < least - same ? std::optional(at) : std::nullopt;
      least = std::min(least, off);
    }
    knot = next;
  }
  return nearest;
}

bool touch(const Segment& a, const Segment& b) {
  return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

}  // namespace

BoundaryMesh::BoundaryMesh(const EdgeFit& fit, const std::vector<Fan>& fans, const EdgeLimits& limits, Draft& draft)
    : fit_(&fit), draft_(&draft) {
  const Outline& outline = fit.outline();
  const int count = static_cast<int>(outline.pieces().size());
  std::vector<const Fan*> fan_at(count, nullptr);
  for (const Fan& fan : fans) fan_at[fan.junction] = &fan;
  std::vector<int> vertex_at(count, -1);
  for (int j = 0; j < count; ++j) {
    if (fan_at[j]) continue;
    const int place = outline.junctions()[j].place;
    vertex_at[j] = place < j ? vertex_at[place] : draft.add_vertex(outline.junctions()[j].position);
  }
  for (int p = 0; p < count; ++p) {
    const SmoothPiece& piece = outline.pieces()[p];
    const Fan* const start = fan_at[p];
    const Fan* const end = fan_at[piece.next];
    if (start) add_rim(*start);
    if (outline.is_second_side(p)) continue;
    add_piece(p, start ? start->rim.front() : vertex_at[p], end ? end->rim.back() : vertex_at[piece.next],
              start ? start->t_out.back() : piece.t0, end ? end->t_in.back() : piece.t1, limits);
  }
  bound_at_junctions(vertex_at);
}

void BoundaryMesh::bound_at_junctions(const std::vector<int>& vertex_at) {
  std::map<int, double> greatest;  // length of the segments at a vertex
  for (std::size_t j = 0; j < vertex_at.size(); ++j) {
    const double length = greatest_edge_length(fit_->outline().junctions()[j]);
    if (vertex_at[j] < 0 || !std::isfinite(length)) continue;
    double& least = greatest.try_emplace(vertex_at[j], length).first->second;
    least = std::min(least, length);
  }
  const auto is_too_long = [&](const Segment& segment) {
    return std::ranges::any_of(std::array{segment.from, segment.to}, [&](int vertex) {
      const auto found = greatest.find(vertex);
      return found != greatest.end() && segment.length() > found->second * slack;
    });
  };
  for (int i = 0; i < static_cast<int>(segments_.size()); ++i)
    while (!segments_[i].is_rim() && is_too_long(segments_[i])) split(i);
}

void BoundaryMesh::append(Segment segment) {
  const Vec2 from = draft_->vertices[segment.from], to = draft_->vertices[segment.to];
  segment.samples.front() = from;
  segment.samples.back() = to;
  if (segment.is_rim() || fit_->outline().face().curves[segment.curve].degree == 1) {
    for (int k = 1; k < 4; ++k) segment.samples[k] = from + (k / 4.0) * (to - from);
  } else {
    const Nurbs& curve = fit_->outline().face().curves[segment.curve];
    const ArcLengthTable stretch(curve, segment.t0, segment.t1);
    for (int k = 1; k < 4; ++k) segment.samples[k] = curve::point(curve, stretch.parameter(k / 4.0));
  }
  segment.centre = (from + to) / 2;
  for (const Vec2 x : segment.samples) segment.radius = std::max(segment.radius, distance(x, segment.centre));
  segments_.push_back(segment);
}

void BoundaryMesh::add_rim(const Fan& fan) {
  for (std::size_t i = fan.rim.size() - 1; i > 0; --i) {
    Segment segment;
    segment.from = fan.rim[i];
    segment.to = fan.rim[i - 1];
    segment.s1 = distance(draft_->vertices[segment.from], draft_->vertices[segment.to]);
    append(segment);
  }
}

void BoundaryMesh::add_piece(int piece, int from, int to, double t0, double t1, const EdgeLimits& limits) {
  const SmoothPiece& whole = fit_->outline().pieces()[piece];
  const curve::ArcLength& arc_length = fit_->outline().arc_length(whole.curve);
  const double s0 = t0 == whole.t0 ? whole.s0 : arc_length.at(t0), s1 = t1 == whole.t1 ? whole.s1 : arc_length.at(t1);
  const double turn = whole.is_straight ? 0 : fit_->turn(whole.curve, t0, t1);
  const double parts = std::max(turn / limits.turn, (s1 - s0) / limits.size) / slack;
  // A loop that consists of one piece needs at least three segments to form a polygon.
  const int num_parts = std::max(whole.next == piece ? 3 : 1, static_cast<int>(std::ceil(parts)));
  for (int i = 0; i < num_parts; ++i) {
    Segment segment;
    segment.curve = whole.curve;
    segment.from = i == 0 ? from : segments_.back().to;
    segment.s0 = i == 0 ? s0 : segments_.back().s1;
    segment.t0 = i == 0 ? t0 : segments_.back().t1;
    segment.s1 = i + 1 == num_parts ? s1 : s0 + (s1 - s0) * (i + 1) / num_parts;
    segment.t1 = i + 1 == num_parts ? t1 : arc_length.parameter(segment.s1);
    segment.to = i + 1 == num_parts ? to : draft_->add_vertex(fit_->outline().at(whole.curve, segment.t1));
    append(segment);
  }
  const int last = static_cast<int>(segments_.size());
  if (!whole.is_straight)
    for (int i = last - num_parts; i < last; ++i) split_to_limits(i, limits, 0);
}

void BoundaryMesh::split_to_limits(int i, const EdgeLimits& limits, int depth) {
  const Segment segment = segments_[i];
  const int max_fit_depth = fit_->order() >= high_order ? max_fit_depth_high : max_fit_depth_low;
  const bool turns = depth < max_turn_depth && fit_->turn(segment.curve, segment.t0, segment.t1) > limits.turn * slack;
  if (!turns && (depth >= max_fit_depth || fit_->error(segment.curve, segment.t0, segment.t1) <= limits.curve_tol))
    return;
  const auto knot = turns ? std::nullopt
                          : inner_knot(fit_->outline().face().curves[segment.curve],
                                       fit_->outline().arc_length(segment.curve), segment);
  split_at(i, knot ? *knot : middle(segment));
  split_to_limits(static_cast<int>(segments_.size()) - 1, limits, depth + 1);
  split_to_limits(i, limits, depth + 1);
}

SplitPoint BoundaryMesh::middle(const Segment& segment) const {
  if (segment.is_rim()) throw Defect("the rim of a fan is not split");
  const ArcLengthTable stretch(fit_->outline().face().curves[segment.curve], segment.t0, segment.t1);
  return {stretch.parameter(0.5), (segment.s0 + segment.s1) / 2};
}

int BoundaryMesh::split_at(int i, SplitPoint at) {
  Segment first = segments_[i], second = segments_[i];
  const Outline& outline = fit_->outline();
  const Vec2 middle = outline.at(first.curve, at.t);
  if (first.length() < tolerance::round_off * outline.face().diameter)
    refuse_contact({i}, "the boundary touches or crosses itself, or nearly");
  first.to = second.from = draft_->add_vertex(middle);
  first.t1 = second.t0 = at.t;
  first.s1 = second.s0 = at.s;
  first.radius = second.radius = 0;
  append(first);
  segments_[i] = segments_.back();
  segments_.pop_back();
  append(second);
  return first.to;
}

bool BoundaryMesh::is_too_near(int i, double ratio, const SegmentGrid& grid) const {
  const Segment& segment = segments_[i];
  const double least = segment.length() / ratio, reach = least + segment.radius + grid.largest_radius;
  bool is_near = false;
  grid.centres.visit_box(segment.centre - Vec2{reach, reach}, segment.centre + Vec2{reach, reach}, [&](int k) {
    const Segment& other = segments_[k];
    if (is_near || k == i || norm(segment.centre - other.centre) - segment.radius - other.radius >= least) return;
    is_near = !touch(segment, other) && segment_distance(segment, other) < least * (1 - 1e-6);
  });
  return is_near;
}

BoundaryMesh::SegmentGrid BoundaryMesh::segment_grid() const {
  std::vector<Vec2> centres;
  double largest = 0;
  for (const Segment& segment : segments_) {
    centres.push_back(segment.centre);
    largest = std::max(largest, segment.radius);
  }
  return {PointGrid(std::move(centres)), largest};
}

void BoundaryMesh::resolve_gaps(double ratio) {
  // A segment that has sufficient clearance needs no further check: splitting other segments does not reduce it.
  std::vector<int> open(segments_.size());
  std::iota(open.begin(), open.end(), 0);
  while (!open.empty()) {
    // All segments of a round are selected before any is split, so that a symmetric boundary stays symmetric.
    const SegmentGrid grid = segment_grid();
    std::vector<int> marked;
    for (const int i : open)
      if (!segments_[i].is_rim() && is_too_near(i, ratio, grid)) marked.push_back(i);
    if (segments_.size() + marked.size() > max_segments)
      refuse_contact(marked,
                     fmt::format("the boundary touches or crosses itself, or the face is so narrow that it takes "
                                 "more than {} element edges",
                                 max_segments));
    open = marked;
    for (const int i : marked) {
      split(i);
      open.push_back(static_cast<int>(segments_.size()) - 1);
    }
  }
}

// The least distance of segment i from those that it does not touch, or `most` if that is less.
double BoundaryMesh::gap_at(int i, double most) const {
  const Segment& segment = segments_[i];
  for (const Segment& other : segments_) {
    if (&other == &segment || touch(segment, other)) continue;
    if (distance(segment.centre, other.centre) - segment.radius - other.radius >= most) continue;
    most = std::min(most, segment_distance(segment, other));
  }
  return most;
}

// Names the narrowest place among the segments `near`, and the sharpest corner if it is one of those that --blunt cuts
// off.
void BoundaryMesh::refuse_contact(const std::vector<int>& near, const std::string& what) const {
  const CadFace& face = fit_->outline().face();
  double gap = face.diameter;
  int narrowest = near.front();
  for (const int i : near)
    if (const double here = gap_at(i, gap); here < gap) narrowest = i, gap = here;
  const auto& junctions = fit_->outline().junctions();
  const auto sharpest = std::min_element(junctions.begin(), junctions.end(), [](const Junction& a, const Junction& b) {
    return a.interior_angle < b.interior_angle;
  });
  const std::string remedy =
      sharpest->interior_angle >= blunted_angle
          ? "draw these parts further apart"
          : fmt::format("the corner of {:.2g} degrees at {} is sharp: cut its tip off with --blunt, or draw it wider",
                        degrees(sharpest->interior_angle), surface::rounded_position_text(face, sharpest->position));
  throw ComputeError(fmt::format("{}: it is {:.2g} ({:.2g} diameters) wide at {}: {}", what, gap, gap / face.diameter,
                                 surface::rounded_position_text(face, segments_[narrowest].samples[2]), remedy));
}

void BoundaryMesh::grade(double growth, const std::vector<SizePoint>& size_points) {
  constexpr int max_rounds = 60;
  const TriangleSizes limits({}, HUGE_VAL, growth, size_points);
  for (int round = 0; round < max_rounds; ++round) {
    const TriangleSizes sizes(segments_, fit_->outline().face().diameter, growth);
    std::vector<int> marked;
    for (int i = 0; i < static_cast<int>(segments_.size()); ++i) {
      const Segment& segment = segments_[i];
      const Vec2 middle = segment.samples[2];
      const double most = std::min(2 * sizes.at(middle), limits.at(middle));
      if (!segment.is_rim() && segment.length() > slack * most) marked.push_back(i);
    }
    if (marked.empty()) return;
    for (const int i : marked) split(i);
  }
}

}  // namespace quadrille::triangulate
