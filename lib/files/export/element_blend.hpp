#pragma once
// The loss if a reader knows only the sides of an element and rebuilds its interior from them by the blend of Gordon
// and Hall,
//   x(xi, eta) = ((1 - xi) x4(eta) + (1 + xi) x2(eta) + (1 - eta) x1(xi) + (1 + eta) x3(xi)) / 2 - bilinear(corners).
// With sides of degree N that is an element of order N again. Where elements are the blend of their sides, and sides
// the segment between their ends, a format may omit curves. The part of a transfinite blend between two values of xi
// and two of eta is the blend of its own sides, so elements cut out of a blended block lose nothing.

#include <string>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

enum class RebuiltFrom { sides, quadratic_sides };

struct TransfiniteLoss {
  double interior = 0;  ///< largest distance between a mesh node and the rebuilt element at the same (xi, eta)
  double sides = 0;     ///< the same on the sides only (not 0 for quadratic ones)
};

/// Throws ComputeError with the position if the Jacobian of a rebuilt element is not proved positive. `reader` is the
/// name of the reading program, for the message. Lengths in the unit of the file.
TransfiniteLoss transfinite_loss(const QuadMesh& mesh, RebuiltFrom from, const std::string& reader);

/// "3.1e-05 (1.5e-05 of the diameter)", or "less than 1e-12 of the diameter".
std::string length_text(double length, double diameter);

/// Largest distance of an inner node from the blend of the element's sides; 0 for order 1. Unit
/// of the file.
double distance_from_side_blend(const QuadMesh& mesh, int elem);

/// Whether an edge is the straight line between its ends at constant speed, as a reader draws a side without nodes of
/// its own; its nodes are at Gauss-Lobatto-Legendre points, ends included. Within 1e-10 of its length.
bool is_straight_edge(const QuadMesh& mesh, const std::vector<int>& edge_nodes);

}  // namespace quadrille::exports
