#pragma once
// What is read from a CAD file.

#include <vector>

#include "model/cad_face.hpp"
#include "model/repair.hpp"

namespace quadrille::cad {

struct LoadedFace {
  CadFace face;
  std::vector<Repair> repairs;  ///< what healing changed
};

}  // namespace quadrille::cad
