#pragma once
// The faces of a T-mesh (trace/t_mesh.hpp): four sides each, with T-junctions on them.

#include <array>
#include <vector>

#include "model/separatrix_graph.hpp"
#include "trace/planar_faces.hpp"

namespace quadrille {

/// A face of a T-mesh: the darts of its four sides, counter-clockwise.
using TFace = std::array<std::vector<int>, 4>;

/// Throws ComputeError, naming a place, unless every face has four corners and no sector but quarters and halves.
std::vector<TFace> t_mesh_faces(const SeparatrixGraph& graph);

}  // namespace quadrille
