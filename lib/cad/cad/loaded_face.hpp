#pragma once
// What is read from a CAD file.

#include <array>
#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/repair.hpp"

namespace quadrille::cad {

struct LoadedFace {
  CadFace face;
  std::vector<Repair> repairs;  ///< what healing changed
};

/// A face or an edge as it is in the file, in space and in the length unit of the file.
struct ListedShape {
  std::string name;                      ///< empty if the file states none
  std::string kind;                      ///< of the surface ("plane", "cylinder") or the curve ("line", "circle")
  double length = 0;                     ///< of the edge, or of all edges of the face
  std::array<double, 3> place{0, 0, 0};  ///< the middle of the edge, or the centre of mass of the edges of the face
};

struct ListedFace {
  ListedShape face;
  std::string part;   ///< names of the products, solids and shells around it, outermost first: "rig/bolt"
  std::string layer;  ///< of the face, else of the innermost part that has one
  std::vector<ListedShape> edges;
};

struct FaceList {
  std::string length_unit;
  std::vector<ListedFace> faces;
  std::vector<std::string> not_built;  ///< entities of faces that could not be built: "#40 'lid'"
};

}  // namespace quadrille::cad
