#pragma once
// Elements of order 2 without nodes inside elements and faces (serendipity elements): 8 nodes of a quad, 20 of a
// hexahedron. Meshes of order 1 stay as they are.

#include <string>
#include <vector>

#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// By mesh node: its number from 1, in the order of the mesh; 0 inside elements and faces.
std::vector<int> serendipity_numbers(const QuadMesh& quads);
std::vector<int> serendipity_numbers(const HexMesh& mesh);

/// "nodes in the middle of elements are not stored, which moves these middles by up to 0.02 (0.001 of the diameter)";
/// empty below 1e-12 of the diameter. Throws ComputeError with the position if such an element is folded; `reader` is
/// the program, for the message.
std::string serendipity_loss(const QuadMesh& quads, const char* reader);
std::string serendipity_loss(const HexMesh& mesh, const char* reader);

}  // namespace quadrille::exports
