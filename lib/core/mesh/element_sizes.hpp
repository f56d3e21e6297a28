#pragma once
// Lengths and areas of a quad mesh's elements, which the scaled Jacobian (a sine) does not see: the ratio of the sides
// of an element, the ratio of the areas of neighbours, the distance between nodes.

#include <string>

#include "base/report.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

/// Fills in elem_edge_ratio, elem_area_jump and elem_node_distance. Lengths and areas by Gauss-Lobatto-Legendre
/// quadrature at the nodes; a ratio to nothing is 1e300. O(n log n) for n elements.
void measure_element_sizes(QuadMesh& mesh);

/// The worst of all elements and where they are, in the face's own coordinates (origin included).
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
std::string describe(const ElementSizes& sizes);

/// Reports value, element and position of each of the three (greatest_edge_ratio.*, ...). Elements must be measured.
void report_element_sizes(const QuadMesh& mesh, Report& report);

}  // namespace quadrille::mesh
