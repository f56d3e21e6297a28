#pragma once
// Prescribed element size at a position: min over the boundary segments, and further points, of length + growth x
// distance, at most the global size. Curvature and gaps enter through the lengths of the boundary segments.

#include <array>
#include <vector>

#include "base/vec2.hpp"
#include "curve/pole_box.hpp"
#include "triangulate/triangulate_options.hpp"

namespace quadrille::triangulate {

/// A segment of the boundary of the domain without the corner fans.
struct Segment {
  int from = 0, to = 0;  ///< vertices of the draft; the face on the left
  int curve = -1;        ///< -1: rim of a fan
  double t0 = 0, t1 = 0;
  double s0 = 0, s1 = 0;        ///< arc length on the curve
  std::array<Vec2, 5> samples;  ///< on the curve at quarters of the arc length, ends included
  Vec2 centre;                  ///< of a circle that contains the samples
  double radius = 0;

  bool is_rim() const { return curve < 0; }
  double length() const { return s1 - s0; }
};

/// Least distance between the polylines through the samples of two segments.
double segment_distance(const Segment& a, const Segment& b);

/// The size field of a set of boundary segments.
class TriangleSizes {
 public:
  TriangleSizes(const std::vector<Segment>& segments, double size, double growth,
                const std::vector<SizePoint>& further = {});
  /// The prescribed element size at x, a length. Cost: logarithmic in the number of segments, in general.
  double at(Vec2 x) const;

 private:
  /// Sources first to last - 1 of a binary tree, whose halves are nodes `left` and `left` + 1; -1: a leaf.
  struct Node {
    Node(int first_source, int end_source) : first(first_source), last(end_source) {}
    int first, last, left = -1;
    curve::PoleBox box;     ///< around their positions
    double least_size = 0;  ///< of its sources
  };

  void split(int node);
  double lower_bound(const Node& node, Vec2 x) const;
  void search(int node, Vec2 x, double& least) const;

  std::vector<SizePoint> sources_;
  std::vector<Node> nodes_;
  double size_, growth_;
};

}  // namespace quadrille::triangulate
