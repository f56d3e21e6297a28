#pragma once
// The boundary of the domain without the corner fans: closed loops of segments. A segment is either a part of a curve,
// bisected (by arc length) where needed, or a rim edge of a fan, which is never split. A slit, and an interface of two
// regions, has segments on its first side alone.

#include <string>
#include <vector>

#include "base/point_grid.hpp"
#include "triangulate/corner_fans.hpp"
#include "triangulate/triangle_sizes.hpp"

namespace quadrille::triangulate {

/// Where a segment is split: the parameter of its curve, and the arc length.
struct SplitPoint {
  double t = 0, s = 0;
};

class BoundaryMesh {
 public:
  /// Constructs segments that satisfy the limits, and at junctions without a fan greatest_edge_length(): each smooth
  /// piece is divided into equal parts, which are then bisected where needed. The fans must be built.
  BoundaryMesh(const EdgeFit& fit, const std::vector<Fan>& fans, const EdgeLimits& limits, Draft& draft);

  const std::vector<Segment>& segments() const { return segments_; }
  /// Whether the face is on both sides of the segment: a slit, or an interface of two regions.
  bool is_inner(const Segment& segment) const {
    return !segment.is_rim() && fit_->outline().face().is_interface(segment.curve);
  }
  /// Origin of the face, added to positions in messages.
  const CadFace& face() const { return fit_->outline().face(); }
  /// Bisects segment i: i becomes the first half, the second half is appended. Returns the new vertex of the draft.
  int split(int i) { return split_at(i, middle(segments_[i])); }
  /// Bisects segments until none is longer than `ratio` times its distance to any segment that it does not touch.
  /// Throws ComputeError, with the position, if curves touch.
  void resolve_gaps(double ratio);
  /// Bisects segments until, within a factor of 2, lengths grow by at most `growth` times the distance, both along and
  /// across the boundary, and until none is longer than the sizes at points near it allow.
  void grade(double growth, const std::vector<SizePoint>& size_points = {});

 private:
  void add_piece(int piece, int from, int to, double t0, double t1, const EdgeLimits& limits);
  void add_rim(const Fan& fan);
  void split_to_limits(int i, const EdgeLimits& limits, int depth);
  void append(Segment segment);
  /// Bisects segments at junctions without a fan, whose vertices these are, until none exceeds greatest_edge_length().
  void bound_at_junctions(const std::vector<int>& vertex_at);
  SplitPoint middle(const Segment& segment) const;
  int split_at(int i, SplitPoint at);
  /// The segments by their centres, to find those near another.
  struct SegmentGrid {
    PointGrid centres;
    double largest_radius = 0;
  };
  SegmentGrid segment_grid() const;
  bool is_too_near(int i, double ratio, const SegmentGrid& grid) const;
  double gap_at(int i, double most) const;
  [[noreturn]] void refuse_contact(const std::vector<int>& near, const std::string& what) const;

  const EdgeFit* fit_;
  Draft* draft_;
  std::vector<Segment> segments_;
};

}  // namespace quadrille::triangulate
