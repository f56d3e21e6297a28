#pragma once
// Delaunay refinement (Ruppert 1995) of the domain without the corner fans: segments are bisected on their curves, and
// circumcentres of triangles that are too large or too thin are inserted unless they encroach on a segment.

#include <map>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "triangulate/boundary_mesh.hpp"
#include "triangulate/delaunay.hpp"
#include "triangulate/triangle_sizes.hpp"

namespace quadrille::triangulate {

class DomainRefiner {
 public:
  /// Triangulates the given segments. `boundary` and `draft` must outlive the refiner. Throws ComputeError if segments
  /// cross.
  DomainRefiner(BoundaryMesh& boundary, Draft& draft, double size, double growth,
                const std::vector<SizePoint>& size_points = {});

  /// Refines until sizes and angles satisfy the limits. The size field is fixed at construction.
  void refine(Progress* progress = nullptr);
  /// Bisects the segment between two vertices of the draft; returns false if it must not be bisected.
  bool split_between(int from, int to);
  /// The triangles, as vertices of the draft, in an order that depends on the vertices only.
  std::vector<std::array<int, 3>> triangles() const;

 private:
  struct Candidate {
    Vec2 centre;
    double circumradius = 0;
    int triangle = 0;
    bool is_thin = false;
  };
  struct Candidates {
    std::vector<Candidate> all;
    double num_triangles = 0;  ///< expected at the end, for the display of progress
  };
  using Triangles = std::vector<DelaunayTriangle>;

  int add_point(int draft_vertex);
  /// The segment between two vertices of the draft: with the face on the left, or a slit from either side; -1: none.
  int segment_between(int from, int to) const;
  void constrain(const Segment& segment);
  void split(int segment);
  bool may_split(int segment) const;
  bool split_encroached(const Triangles& triangles);
  bool insert_centres(const Triangles& triangles, Progress* progress);
  Candidates candidates(const Triangles& triangles);
  /// Sets `blockers` to the segments on which the circumcentre encroaches, or to the first segment between it and its
  /// triangle.
  void find_blockers(const Triangles& triangles, const Candidate& candidate, std::vector<int>& blockers) const;
  Vec2 position(int point) const { return draft_->vertices[point2vertex_[point]]; }

  BoundaryMesh* boundary_;
  Draft* draft_;
  TriangleSizes sizes_;
  ConstrainedDelaunay delaunay_;
  std::vector<int> point2vertex_, vertex2point_;
  std::vector<std::array<int, 3>> good_;  ///< triangles within the limits (the size field is fixed), sorted
  std::map<std::pair<int, int>, int> vertices2segment_;  ///< (from, to), vertices of the draft
};

}  // namespace quadrille::triangulate
