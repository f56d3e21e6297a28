#pragma once
// How good the blocks of a layout are, to tell whether a collapse is worth it.

#include <vector>

#include "graph/planar_faces.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::simplify {

/// The worst of some blocks.
struct BlockShape {
  double least_angle = 4, greatest_angle = 0;  ///< at corners, radians
  double least_scaled_jacobian = 1;            ///< of blocks sampled as quads of order 8
  bool is_valid = true;                        ///< all Jacobians proved positive
};

/// Of the faces of four corners that `chosen` names.
BlockShape worst_shape(const SeparatrixGraph& graph, const graph::PlanarFaces& faces, const std::vector<int>& chosen);

/// Faces with a side among the marked arcs, ascending.
std::vector<int> faces_beside(const graph::PlanarFaces& faces, const std::vector<bool>& is_marked);

}  // namespace quadrille::simplify
