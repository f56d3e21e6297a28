#pragma once
// All faces of an OpenCASCADE model at their places, with the parts that hold them.

#include <TopoDS_Face.hxx>
#include <string>
#include <vector>

#include "occ/occ_model.hpp"

namespace quadrille::occ {

struct PlacedFace {
  TopoDS_Face face;
  std::vector<std::string> parts;  ///< names of the products, solids and shells around it, outermost first
  std::string layer;               ///< of the face, else of the innermost part that has one

  std::string part_path() const;  ///< "rig/bolt"
};

/// In the order of the file. A face that an assembly places several times is found at each place; one that two parts
/// share is found once, in the first of them.
std::vector<PlacedFace> placed_faces(const OccModel& model);

}  // namespace quadrille::occ
