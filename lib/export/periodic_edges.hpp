#pragma once
// Periodic sides of a mesh, as formats with periodic boundaries need them.

#include <array>
#include <string>
#include <vector>

#include "export/frame.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// Two boundary edges of which one is the image of the other, in the opposite direction.
struct PeriodicEdges {
  int first = 0, second = 0;  ///< of QuadMesh::boundary_edges: on the first and on the second curve of the pair
  int pair = 0;               ///< of CadFace::periodic_pairs
};

/// Throws ComputeError, with the place, for an edge on a periodic curve that has no image within 1e-9 diameters.
std::vector<PeriodicEdges> periodic_edges(const QuadMesh& mesh);

/// The motion of a pair in a frame, row by row: it maps (x, y, z, 1) of the first curve onto the second.
std::array<double, 16> affine_motion(const CadFace& face, int pair, const Frame& frame);

/// A sentence that the format does not store the periodic sides; empty if there are none.
std::string periodic_loss(const CadFace& face);

}  // namespace quadrille::exports
