#pragma once
// A constrained Delaunay triangulation that grows point by point. The only door to CGAL: no kernel type in here.
//
// Inside are the triangles that an odd number of constraints separates from infinity: constraints form closed,
// mutually disjoint loops (outline, holes). Predicates are exact; coordinates are never changed.

#include <array>
#include <memory>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::triangulate {

/// Vertices counter-clockwise; local edge k runs from vertex k to vertex k+1 (mod 3).
struct DelaunayTriangle {
  std::array<int, 3> vertices;
  std::array<int, 3> neighbors;  ///< across local edge k: index into the same list, -1 across a constraint
};

class ConstrainedDelaunay {
 public:
  ConstrainedDelaunay();
  ~ConstrainedDelaunay();

  /// Returns the number of the new vertex (0, 1, 2, ...), or that of the vertex which is already at this position.
  int insert(Vec2 position);
  /// Makes the segment between two vertices an edge for good. False, and nothing is done, where it crosses another
  /// constraint or passes through a third vertex.
  bool constrain(int a, int b);
  /// Takes a constraint back; the edge may be flipped away.
  void release(int a, int b);
  /// The triangles inside, each beginning with its lowest vertex, sorted: independent of the history.
  std::vector<DelaunayTriangle> triangles() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quadrille::triangulate
