#pragma once
// Delaunay refinement (Ruppert 1995) of what the fans leave: segments are halved on their curves, circumcentres of
// triangles that are too large or too thin are inserted unless they come too near a segment.

#include <map>
#include <utility>
#include <vector>

#include "triangulate/boundary_mesh.hpp"
#include "triangulate/delaunay.hpp"
#include "triangulate/triangle_sizes.hpp"

namespace quadrille::triangulate {

class DomainRefiner {
 public:
  /// Keeps references; triangulates the segments as they are. Throws ComputeError where segments cross.
  DomainRefiner(BoundaryMesh& boundary, Draft& draft, double size, double growth);

  /// Refines until sizes and angles are right. Bounded by the size field, which is fixed at construction.
  void refine();
  /// Halves the segment between two vertices of the draft (if it is one that may be halved; false if not).
  bool split_between(int from, int to);
  /// The triangles, as vertices of the draft, in a sequence that depends on the vertices only.
  std::vector<std::array<int, 3>> triangles() const;

 private:
  struct Candidate {
    Vec2 centre;
    double circumradius = 0;
    int triangle = 0;
    bool is_thin = false;
  };
  using Triangles = std::vector<DelaunayTriangle>;

  int add_point(int draft_vertex);
  void constrain(const Segment& segment);
  void split(int segment);
  bool may_split(int segment) const;
  bool split_encroached(const Triangles& triangles);
  bool insert_centres(const Triangles& triangles);
  std::vector<Candidate> candidates(const Triangles& triangles);
  /// The segments that forbid the point, in `blockers`; the walk starts in a triangle.
  void find_blockers(const Triangles& triangles, const Candidate& candidate, std::vector<int>& blockers) const;
  Vec2 position(int point) const { return draft_->vertices[point2vertex_[point]]; }

  BoundaryMesh* boundary_;
  Draft* draft_;
  TriangleSizes sizes_;
  ConstrainedDelaunay delaunay_;
  std::vector<int> point2vertex_, vertex2point_;
  std::vector<std::array<int, 3>> good_;  ///< triangles that need nothing, sorted: the size field never changes
  std::map<std::pair<int, int>, int> vertices2segment_;  ///< (from, to) of the draft
};

}  // namespace quadrille::triangulate
