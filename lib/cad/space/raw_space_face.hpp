#pragma once
// A curved face between the CAD kernel and the model: its surface, its edges in space, and a fine triangulation, not
// yet checked. No OpenCASCADE types.

#include <array>
#include <vector>

#include "heal/raw_face.hpp"
#include "model/chart.hpp"

namespace quadrille::space {

/// The vertices of the triangulation on an edge, in the direction of its curve.
struct EdgePolygon {
  int edge = 0;  ///< index into RawSpaceFace::curves
  std::vector<int> vertices;
  std::vector<double> parameters;  ///< on the curve, rising
};

struct RawSpaceFace {
  /// File, name, unit, tolerances, labels. One wire has the edges of the face, each used once and without its curve.
  heal::RawFace labels;
  std::vector<SpaceCurve> curves;  ///< of the edges, in the direction of the file
  NurbsSurface surface;
  bool is_reversed = false;

  // As in SpaceFace.
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<Vec2, 3>> triangle_uv;
  std::vector<EdgePolygon> polygons;  ///< of all edges but seams and poles

  /// Number of an edge in the file.
  int cad_edge(int edge) const { return labels.wires.front()[edge].cad_edge; }
};

}  // namespace quadrille::space
