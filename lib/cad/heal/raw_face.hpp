#pragma once
// A face between the CAD kernel and the model: its edges as NURBS in its plane, wire by wire, not yet healed nor
// checked. No OpenCASCADE types.

#include <array>
#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::heal {

/// One edge of the file, in the direction of its wire.
struct RawEdge {
  Nurbs curve;
  Vec2 start, end;       ///< positions of its vertices in the file
  int cad_edge = 0;      ///< number in the file
  std::string name{};    ///< empty if the file has none; likewise layer and colour
  std::string layer{};   ///< name of the layer of the edge
  std::string colour{};  ///< "ff0000" for red
  double height = 0;     ///< greatest distance of the edge in space from the plane of the face
};

struct RawFace {
  std::string file;  ///< for messages
  std::string name, layer;
  int cad_face = -1;  ///< number of the face in the file; -1: its place among the faces that are read
  std::string length_unit = "unknown";
  double metres_per_unit = 0;
  double tolerance = 1e-7;     ///< tolerance of the file, a length: closer points coincide
  double shape_tolerance = 0;  ///< greatest tolerance of the face, an edge or a vertex, a length
  std::array<double, 3> plane_origin{0, 0, 0}, plane_x{1, 0, 0}, plane_y{0, 1, 0};
  std::vector<std::vector<RawEdge>> wires;  ///< in the order of the file
  std::vector<RawEdge> inner_edges;         ///< with the face on both sides; not healed
};

// A closed loop of boundary curves, in the order of the loop, each ending where the next one starts.

/// A curve of the loop without inner tangent jumps, and its edge in the file.
struct LoopCurve {
  Nurbs curve;
  int cad_edge = 0;
  std::string name;
};

using Loop = std::vector<LoopCurve>;

}  // namespace quadrille::heal
