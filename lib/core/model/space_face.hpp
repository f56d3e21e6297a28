#pragma once
// A face in space as it is read from a CAD file, of which cad2chart makes a chart.

#include <array>
#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/chart.hpp"

namespace quadrille {

/// An edge of the fine triangles that lies on a curve, with the triangle on its left.
struct FineBoundaryEdge {
  std::array<int, 2> vertices{};
  int curve = 0;
  double t0 = 0, t1 = 0;  ///< parameters of the two vertices on the curve, t0 < t1
};

/// A curve on the surface with the face on both sides: a crack, or the common edge of two faces of one surface.
struct InnerSpaceCurve {
  SpaceCurve curve;          ///< without tangent jumps inside
  std::string name;          ///< empty if the file has none
  int cad_edge = 0;          ///< number of the edge in the CAD file
  std::array<int, 2> faces;  ///< of the file, on the left and on the right: indices into SpaceFace::face_names
};

/// Several faces of a file that lie on one surface are one SpaceFace: their common edges are inner curves.
/// Seen against the normal (X_u x X_v, or its opposite if `is_reversed`), loops run with the face on their left: the
/// outline counter-clockwise, holes clockwise. Edges that only close the parameters of the surface (seams, poles) are
/// no curves. Consecutive curves of a loop meet bit for bit.
struct SpaceFace {
  /// Unit, name, loop_offsets, curve_names, unnamed_curves, curve_cad_edges; no curves, joints, plane or diameter.
  /// Which loop is the outline (loop 0) does not matter on a surface: it is the longest.
  CadFace face;
  std::vector<SpaceCurve> curves;
  NurbsSurface surface;
  bool is_reversed = false;
  std::vector<InnerSpaceCurve> inner_curves;  ///< the triangles know nothing of them
  double tolerance = 0;                       ///< a length: the most that their ends are moved to meet
  std::vector<std::string> face_names{""};    ///< of the faces of the file; empty if the file has none
  std::vector<int> curve_faces;               ///< of each curve: the face on its left

  // A fine triangulation of the face, topologically right: vertices of both sides of a seam, and those at a pole, are
  // one. Triangles are counter-clockwise seen against the normal, and deviate from the surface by at most 1e-3
  // diameters.
  std::vector<Vec3> vertices;  ///< on the surface
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<Vec2, 3>> triangle_uv;  ///< parameters of the corners, continuous inside each triangle
  std::vector<FineBoundaryEdge> boundary_edges;  ///< sorted by curve, then t0
};

}  // namespace quadrille
