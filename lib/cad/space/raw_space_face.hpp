#pragma once
// A curved face between the CAD kernel and the model: its surface, its edges in space, and a fine triangulation, not
// yet checked. No OpenCASCADE types.

#include <array>
#include <string>
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

/// An edge with faces on both sides.
struct RawInnerEdge {
  SpaceCurve curve;
  std::array<int, 2> faces;  ///< on its left and on its right, as in InnerSpaceCurve
};

struct RawSpaceFace {
  /// File, name, unit, tolerances, labels. One wire has the edges of the face, each used once and without its curve;
  /// its inner edges are those of `inner_edges`.
  heal::RawFace labels;
  std::vector<SpaceCurve> curves;  ///< of the edges, in the direction of the file
  NurbsSurface surface;
  bool is_reversed = false;
  std::vector<RawInnerEdge> inner_edges;
  std::vector<std::string> face_names{""};
  std::vector<int> edge_faces;  ///< of each edge of the wire: the face that it bounds; empty: the only one

  // As in SpaceFace.
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<Vec2, 3>> triangle_uv;
  std::vector<EdgePolygon> polygons;  ///< of all edges but seams and poles

  /// Number of an edge in the file.
  int cad_edge(int edge) const { return labels.wires.front()[edge].cad_edge; }
};

}  // namespace quadrille::space
