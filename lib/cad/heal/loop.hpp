#pragma once
// A closed loop of boundary curves, in the order of the loop, each ending where the next one starts.

#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::heal {

/// A curve of the loop without inner tangent jumps, and its edge in the file.
struct LoopCurve {
  Nurbs curve;
  int cad_edge = 0;
  std::string name;
};

using Loop = std::vector<LoopCurve>;

}  // namespace quadrille::heal
