#pragma once
// Elements cut into smaller ones of order 1 or 2, for formats that have no higher order.
//
// The small elements share the vertices of the mesh, bit for bit, and interpolate its polynomials at their nodes, which
// neighbours share. Boundary edges, interfaces and blocks are those of the mesh.

#include <array>
#include <string>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// Each element as a grid of elements of `order` (1 or 2) between these reference coordinates, ascending from -1 to 1,
/// in both directions: M^2 elements for M intervals, xi1 fastest, in place of the one. Nodes of order 2 lie at the
/// middle of their interval. Nodes are numbered: vertices of the mesh, then its edges, then the insides of elements.
/// Measures of the elements (bounds, sizes) are empty afterwards. Linear cost.
QuadMesh split_elements(const QuadMesh& mesh, const std::vector<double>& breaks, int order);

/// Straight elements between the nodes of a mesh of order N: N^2 for each. The nodes are those of the mesh.
QuadMesh split_at_nodes(const QuadMesh& mesh);

/// Elements of order 2 between equal intervals: none smaller than the elements for order 2, 4 for orders 3 and 4, 9 for
/// orders 5 and 6 ...; a mesh of order 1 as it is.
QuadMesh split_to_quadratic(const QuadMesh& mesh);

/// Whether all corners of a quad with straight sides, counter-clockwise, turn left.
bool is_convex(const std::array<Vec2, 4>& corners);

/// Throws ComputeError with the position if the corners of an element do not all turn left, as they must where a
/// program draws straight sides between them. `reader`: "OpenFOAM's cells", for the message.
void require_convex_cells(const QuadMesh& mesh, const std::string& reader);

/// Throws ComputeError with the position if det J of an element of order 1 or 2 is not proved positive, in space its
/// normal component. `reader` as above.
void require_valid_pieces(const QuadMesh& pieces, const std::string& reader);

/// "elements have straight lines as sides, which moves the boundary by up to 0.02 (0.001 of the diameter)", or
/// parabolas for pieces of order 2: the distance of the boundary of `mesh` from that of the pieces, which one of the
/// functions above made of it. Empty below 1e-12 of the diameter.
std::string split_loss(const QuadMesh& mesh, const QuadMesh& pieces);

}  // namespace quadrille::exports
