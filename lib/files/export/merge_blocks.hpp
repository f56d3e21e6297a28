#pragma once
// Blocks joined to few large grids, for structured solvers.
//
// A set of edges becomes the lines between grids. It makes rectangular grids if no two neighbouring edges around a
// vertex are left out, unless all four of an inner vertex are: then angles of grids are 90 or 180 degrees, and a grid
// with corners has four of them, by the angles of its boundary. So lines start at irregular vertices, go straight on
// through regular ones, and end at the first other line. The number of grids is least where most lines join two
// irregular vertices, of which no two may cross: the partition of a rectilinear polygon into fewest rectangles
// (Ohtsuki, IEEE Symposium on Circuits and Systems, 1982), with irregular vertices in place of reflex corners.

#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The mesh with its elements in as few blocks as possible, each a rectangular grid of whole elements of one region.
/// Interfaces stay lines between blocks. A grid that would touch itself (a ring, or a C around a wake) is cut in the
/// middle, so that no block is its own neighbour. Fewest before those cuts, if the search over the lines between
/// irregular vertices ends within 100,000 steps; else few. Blocks are numbered by their first elements; those without a
/// name stay so. Linear cost, but for the search.
QuadMesh merge_blocks(QuadMesh mesh);

/// The same of hexahedra: blocks of quads that are swept.
HexMesh merge_blocks(HexMesh mesh);

}  // namespace quadrille::exports
