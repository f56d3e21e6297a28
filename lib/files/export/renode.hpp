#pragma once
// The same element polynomials by the points of other formats, in place of Gauss-Lobatto-Legendre nodes: equispaced
// nodes (Gmsh, VTK, CGNS and others), Bernstein control points (VTK's Bezier cells), or the Chebyshev-Lobatto nodes of
// HOHQMesh's formats. Any order N >= 1; lengths have the unit of the file. And what a reader loses that knows the sides
// of an element only.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "export/exported.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// One position for each of mesh.nodes: the node at Gauss-Lobatto-Legendre point (i, j) of an element becomes the new
/// format's node (i, j). `from_gll` [N+1, N+1] maps the nodes of an edge to the new ones; it keeps the ends and is
/// symmetric under reversal of the edge. Vertices keep their position bit for bit; an edge's nodes are computed once
/// and shared.
std::vector<Vec2> renoded(const QuadMesh& mesh, const Eigen::MatrixXd& from_gll);

/// By which points a format defines an element: those of the mesh, equispaced nodes, or Bernstein control points (the
/// change of basis loses about a digit for every three orders). Point (i, j) takes the place of the node at
/// Gauss-Lobatto-Legendre point (i, j). Vertices keep their position bit for bit; an edge's points are computed once
/// and shared.
enum class ElementPoints { nodes, equispaced, bezier };

/// One position in space for each of mesh.nodes: of a planar face in the frame, of a curved one those of the elements
/// in space.
std::vector<std::array<double, 3>> positions(const QuadMesh& mesh, const Frame& frame, ElementPoints points);

/// Of hexahedra: nodes of faces too are evaluated once and shared.
std::vector<std::array<double, 3>> positions(const HexMesh& mesh, ElementPoints points);

/// The same by any matrix that renoded accepts.
std::vector<Vec3> renoded(const HexMesh& mesh, const Eigen::MatrixXd& from_gll);

/// A node of the mesh in the frame, or in space if the face is curved.
std::array<double, 3> position(const QuadMesh& mesh, const Frame& frame, int node);

/// The number of coordinates that positions need: 3 on a curved face and in a frame other than the plane z = 0, else 2.
int space_dimension(const QuadMesh& mesh, const Frame& frame);

/// The order + 1 Chebyshev-Lobatto points t_j = -cos(j pi / N), ascending in [-1, 1], exactly antisymmetric about 0.
std::vector<double> chebyshev_lobatto_points(int order);

// The loss if a reader knows only the sides of an element and rebuilds its interior from them by the blend of Gordon
// and Hall,
//   x(xi, eta) = ((1 - xi) x4(eta) + (1 + xi) x2(eta) + (1 - eta) x1(xi) + (1 + eta) x3(xi)) / 2 - bilinear(corners).
// With sides of degree N that is an element of order N again. Where elements are the blend of their sides, and sides
// the segment between their ends, a format may omit curves. The part of a transfinite blend between two values of xi
// and two of eta is the blend of its own sides, so elements cut out of a blended block lose nothing.

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

/// Largest distance of an inner node from the blend of the element's sides, in space of a curved face; 0 for order 1.
/// Unit of the file.
double distance_from_side_blend(const QuadMesh& mesh, int elem);

/// Whether an edge is the straight line between its ends at constant speed, as a reader draws a side without nodes of
/// its own; its nodes are at Gauss-Lobatto-Legendre points, ends included. Within 1e-10 of its length. Of a curved face
/// it is that in space.
bool is_straight_edge(const QuadMesh& mesh, const std::vector<int>& edge_nodes);

}  // namespace quadrille::exports
