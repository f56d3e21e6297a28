#pragma once
// The isothermal chart of a triangulated face, by four scalar problems (lib/method.md §12): scale, turn of the frame,
// and two coordinates.

#include <vector>

#include "chart/surface_mesh.hpp"

namespace quadrille::chart {

struct IsothermalFit {
  double closedness = 0;             ///< Chart::closedness
  std::vector<double> elem_squares;  ///< parts of its square, by element
};

/// Sets mesh.image and mesh.scale. `loop_offsets`: of the face. The scale is 1 on the outline; at each hole its normal
/// derivative is a + b cos + c sin of the part of the hole's length, such that the image of the hole closes.
IsothermalFit make_isothermal(SurfaceMesh& mesh, const std::vector<int>& loop_offsets);

}  // namespace quadrille::chart
