#pragma once
// An incremental constrained Delaunay triangulation. The only interface to CGAL; it contains no CGAL type.
//
// A triangle is inside if an odd number of constraints separates it from infinity: constraints form closed, mutually
// disjoint loops (outline, holes). Inner constraints, slits and interfaces of regions, have the inside on both sides
// and are not counted. Predicates are exact; coordinates are never changed.

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

  /// Returns the number of the new vertex (0, 1, 2, ...), or the number of an existing vertex at this position.
  int insert(Vec2 position);
  /// Adds the segment between two vertices as a constraint. Returns false and changes nothing if it crosses another
  /// constraint or passes through a third vertex.
  bool constrain(int a, int b, bool is_inner = false);
  /// Removes a constraint; the edge may then be flipped.
  void release(int a, int b);
  /// The triangles inside, each starting with its lowest vertex, sorted: independent of the order of insertion.
  std::vector<DelaunayTriangle> triangles() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quadrille::triangulate
