#pragma once
// Lengths and areas of a quad mesh's elements, which the scaled Jacobian (a sine) does not see: the ratio of the sides
// of an element, the ratio of the areas of neighbours, the distance between nodes.

#include <array>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

/// Fills in elem_edge_ratio, elem_area_jump and elem_node_distance. Lengths and areas by Gauss-Lobatto-Legendre
/// quadrature at the nodes, in space if the mesh has nodes there; a ratio to nothing is 1e300. O(n log n) for n
/// elements.
void measure_element_sizes(QuadMesh& mesh);

/// The mean of an element's corners, relative to face.origin.
Vec2 centre(const QuadMesh& mesh, int elem);

/// The worst of all elements, and the positions of their centres relative to face.origin.
struct ElementSizes {
  double edge_ratio = 1;     ///< greatest
  double area_jump = 1;      ///< greatest
  double node_distance = 0;  ///< least, a length
  int edge_ratio_elem = 0, area_jump_elem = 0, node_distance_elem = 0;
  Vec2 edge_ratio_position, area_jump_position, node_distance_position;
};

/// Elements must be measured.
ElementSizes worst_element_sizes(const QuadMesh& mesh);

/// "greatest edge ratio 12.3 at (1, 2), ...": one line.
std::string describe(const ElementSizes& sizes, const CadFace& face);

/// Reports value, element and position of each of the three (greatest_edge_ratio.*, ...). Elements must be measured.
void report_element_sizes(const QuadMesh& mesh, Report& report);

// The resolution ratio R of a quad mesh: how much a solution that is equally smooth in all directions loses to elements
// of unequal sizes, without solving for it.
//
// The squared L2 error of polynomials of degree p in an element is proportional to the integral of
// |x_xi1|^2q + |x_xi2|^2q over it, q = p + 1 (skewness of a parallelogram costs nothing). With lengths in units of the
// prescribed length h of each element,
//
//   E = sum over elements of  int (|x_xi1 / h|^2q + |x_xi2 / h|^2q) dA / h^2,   R = E / (2 A (A / n)^q),
//
// xi in [0, 1]^2, A = int dA / h^2, n elements: the denominator is E of n equal squares. So R >= 1, and the error is
// about sqrt(R) times theirs. q = 4. Where a metric is prescribed, x_xi1 and x_xi2 are those times its tensor S of
// determinant 1 (QuadMesh::elem_prescribed_stretch): lengths and areas are in the metric, and R is the error of a
// solution whose variation is equal in all directions there.

constexpr int resolution_power = 4;  ///< q

struct Resolution {
  double ratio = 1;  ///< R of the elements that count; 1 if none does
  /// By element: the parts of E that its lengths along xi1 and xi2 have, of all 1. 0 where it does not count.
  std::vector<std::array<double, 2>> parts;
};

/// Without prescribed lengths (elem_prescribed_length), h is the same for all elements; those with the length 0 do not
/// count. `greatest_lengths`: limits of h along xi1 and xi2 of each element, |x_xi1| and |x_xi2| each in units of their
/// own and areas in those of their product; empty: none. O(N^3) for each element of order N.
Resolution resolution(const QuadMesh& mesh, const std::vector<Vec2>& greatest_lengths = {});

/// The parts of one element in E and A, h the same in both directions.
struct ElementPowers {
  std::array<double, 2> along{};  ///< of E, by direction
  double area = 0;
};

/// Of all elements, with lengths in units of the prescribed ones; 0 where an element does not count.
std::vector<ElementPowers> element_powers(const QuadMesh& mesh);

/// The same from the parts of all elements, however they were integrated: of those that count.
Resolution resolution(const QuadMesh& mesh, const std::vector<Vec2>& greatest_lengths,
                      const std::vector<ElementPowers>& powers);

/// The prescribed length h of an element; 0: it does not count.
double resolution_length(const QuadMesh& mesh, int elem);

/// By element: the square root of its area over the prescribed length; 1 where wall layers prescribe it. Prescribed
/// lengths must be stored.
std::vector<double> relative_sizes(const QuadMesh& mesh);

}  // namespace quadrille::mesh
