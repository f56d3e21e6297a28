#pragma once
// The boundary of what is left to triangulate when the fans are cut out: closed loops of segments, each a stretch of
// curve that is halved (by arc length) where needed, or a rim edge of a fan, which stays as it is.

#include <vector>

#include "triangulate/boundary_segment.hpp"
#include "triangulate/corner_fans.hpp"

namespace quadrille::triangulate {

class BoundaryMesh {
 public:
  /// Segments that keep the limits: every piece in equal parts first, then halved. Fans must be built.
  BoundaryMesh(const EdgeFit& fit, const std::vector<Fan>& fans, const EdgeLimits& limits, Draft& draft);

  const std::vector<Segment>& segments() const { return segments_; }
  /// Of the face: what messages add to a position.
  Vec2 origin() const { return fit_->outline().face().origin; }
  /// Halves segment i: i keeps the first half, the new last segment is the second one. Returns the new vertex.
  int split(int i);
  /// Halves segments until none is longer than `ratio` times its distance to any segment that it does not touch.
  /// Throws ComputeError where curves touch.
  void resolve_gaps(double ratio);
  /// Halves segments until lengths grow along and across the boundary by no more than `growth` times the distance,
  /// within a factor of 2.
  void grade(double growth);

 private:
  void add_piece(int piece, int from, int to, double t0, double t1, const EdgeLimits& limits);
  void add_rim(const Fan& fan);
  void split_to_limits(int i, const EdgeLimits& limits, int depth);
  void append(Segment segment);
  bool is_too_near(int i, double ratio) const;
  [[noreturn]] void refuse_contact() const;

  const EdgeFit* fit_;
  Draft* draft_;
  std::vector<Segment> segments_;
};

}  // namespace quadrille::triangulate
