#pragma once
// A face between the CAD kernel and the model: its edges as NURBS of the plane, wire by wire, not yet checked.
// Private to this folder; no kernel names.

#include <array>
#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::cad {

/// One edge of the file as its wire walks it.
struct RawEdge {
  Nurbs curve;
  Vec2 start, end;       ///< the vertices that the file gives it
  int cad_edge = 0;      ///< number in the file
  std::string name{};    ///< empty where the file has none; likewise the two others
  std::string layer{};   ///< name of the layer on which it is
  std::string colour{};  ///< "ff0000" for red
};

struct RawFace {
  std::string file;  ///< for messages
  std::string name, layer;
  std::string length_unit = "unknown";
  double metres_per_unit = 0;
  double tolerance = 1e-7;  ///< the file's own: below it points are the same
  std::array<double, 3> plane_origin{0, 0, 0}, plane_x{1, 0, 0}, plane_y{0, 1, 0};
  std::vector<std::vector<RawEdge>> wires;  ///< in the sequence of the file
};

}  // namespace quadrille::cad
