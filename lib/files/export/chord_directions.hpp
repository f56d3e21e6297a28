#pragma once
// Edges directed so that opposite sides of every element are parallel, and elements that start where both directions
// begin.
//
// A chord crosses each element from one side to the opposite one. Edges that run from its right to its left are
// parallel. Such directions always exist: a chord of a mesh in the plane has a left and a right, so it cannot return to
// an edge with both exchanged. A chord that crosses itself passes an element twice, once through each pair of sides.

#include "export/edge_numbering.hpp"

namespace quadrille::exports {

/// The same elements, each with its nodes in the order that starts at the corner where the directions of its sides
/// begin: sides 0 and 2 run along xi1, sides 1 and 3 along xi2. The edge of least number on a chord determines the
/// direction of all (from its vertex of lower number, as number_edges has it). Linear cost.
QuadMesh turned_along_chords(const QuadMesh& mesh);

/// number_edges of a mesh that is turned along its chords, with edges in the directions of their chords, which need not
/// begin at the vertex of lower number.
EdgeNumbering number_directed_edges(const QuadMesh& turned);

}  // namespace quadrille::exports
