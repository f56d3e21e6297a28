#pragma once
// The faces of a T-mesh (quantize/t_mesh.hpp): four sides each, with T-junctions on them.

#include <array>
#include <vector>

#include "graph/subdivision.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::quantize {

/// A face of a T-mesh: the half-edges of its four sides, counter-clockwise.
using TFace = std::array<std::vector<HalfEdge>, 4>;

/// Throws ComputeError with a position unless every face has four corners and all its other sectors are half turns.
std::vector<TFace> t_mesh_faces(const graph::Subdivision& subdivision);

}  // namespace quadrille::quantize
