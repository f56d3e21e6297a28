#pragma once
// The triangles of a curved face while they are changed: who is where, and how good they are.

#include <array>
#include <set>
#include <vector>

#include "space/raw_space_face.hpp"

namespace quadrille::space {

/// Corners of a triangle have parameters that are continuous in it, as in SpaceFace.
struct SurfaceCorner {
  int vertex = 0;
  Vec2 uv;
};
using Triangle = std::array<SurfaceCorner, 3>;

class SurfaceTriangles {
 public:
  /// Those of `raw`, which must outlive this. New vertices are added to it.
  explicit SurfaceTriangles(RawSpaceFace& raw);

  /// Sets the triangles of the face, without triangles and vertices that were removed.
  void store();

 protected:
  /// 1 for an equilateral triangle, 0 for one without area, negative if it is seen from behind.
  double shape(const Triangle& t) const;
  /// Of a new triangle, which must be counter-clockwise in the parameters (else -1): so triangles that the kernel made
  /// too coarse, and that look turned over in space, are right when they are finer.
  double checked_shape(const Triangle& t) const;

  int position(int t, int vertex) const;  ///< of the corner; -1: none
  std::vector<int> triangles_with(int a, int b) const;
  std::set<int> neighbours(int v) const;
  int longest_side(int t) const;
  /// Parameters in the middle of a side.
  Vec2 middle(const SurfaceCorner& a, const SurfaceCorner& b) const;
  /// Whole periods of the surface nearest to the difference of two parameters.
  Vec2 whole_periods(Vec2 difference) const;

  void replace(int t, const Triangle& triangle);
  void add(const Triangle& triangle);
  void remove(int t);
  int new_vertex(Vec3 x, Vec2 uv, bool is_fixed);

  bool is_pole(int v) const { return free_[v] != nullptr; }
  /// At a pole, one parameter says nothing: it is set to that of the middle of the other corners.
  void set_poles(Triangle& t) const;

  RawSpaceFace& raw_;
  std::vector<Triangle> triangles_;  ///< vertex -1: removed
  std::vector<double> shapes_;
  std::vector<std::vector<int>> around_;  ///< triangles at each vertex
  std::vector<bool> is_fixed_;            ///< vertices on edges of the file, and poles
  double size_ = 0;                       ///< of the face, a length

 private:
  Vec3 normal(Vec2 uv) const;
  void fix_vertices();

  std::vector<double Vec2::*> free_;  ///< at poles: the parameter that says nothing
  std::vector<Vec3> normals_;         ///< unit; zero at poles
  double least_area_ = 0;             ///< of a triangle in the parameters
};

}  // namespace quadrille::space
