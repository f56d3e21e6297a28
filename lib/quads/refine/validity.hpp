#pragma once
// Validity of a mesh's elements: the proved lower bounds of det J, the scaled Jacobians (lib/method.md §7), and the
// worst elements.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::refine {

/// The geometry nodes of one element, as model/quad_mesh.hpp numbers them.
std::vector<Vec2> element_nodes(const QuadMesh& mesh, int elem);
/// Those in space, of a curved face.
std::vector<Vec3> element_space_nodes(const QuadMesh& mesh, int elem);

/// Fills in the bounds and scaled Jacobians of all elements, in space if the mesh has nodes there, the least bound and
/// whether all are proved valid. `known`: a measured mesh of the same blocks, whose figures are taken where a block has
/// the same elements.
void measure_elements(QuadMesh& mesh, Progress* progress = nullptr, const QuadMesh* known = nullptr);

/// Fills in bound and scaled Jacobian of one element of a measured mesh; summarise_validity is to follow.
void measure_element(QuadMesh& mesh, int elem);
/// The least bound, and whether all elements are proved valid, from the bounds of all.
void summarise_validity(QuadMesh& mesh);

/// Of the measured elements.
double least_scaled_jacobian(const QuadMesh& mesh);
double mean_scaled_jacobian(const QuadMesh& mesh);

/// One of the worst elements, and the position of its least scaled Jacobian, relative to face.origin.
struct WorstElement {
  int elem = 0;
  Vec2 position;
  double scaled_jacobian = 0;  ///< -1 if det J <= 0
  double bound = 0;            ///< of det J
};

/// The `count` worst elements: those that are not proved valid by ascending bound, then the others by ascending scaled
/// Jacobian; equals (within 1e-6) by number. All if there are fewer. Elements must be measured.
std::vector<WorstElement> worst_elements(const QuadMesh& mesh, int count);

/// "element 7 of block-2 at (0.3, 0.1): scaled Jacobian 0.42, det J >= 0.0012"
std::string describe(const WorstElement& worst, const QuadMesh& mesh);

/// The least over all elements of the least det J of the element over its greatest one, to 1e-4 (what Gmsh calls minJ /
/// maxJ); if det J is negative, over its greatest absolute value instead: then in [-1, 0].
double least_jacobian_ratio(const QuadMesh& mesh);

/// Throws ComputeError with the position of the worst element if one is not proved valid.
void require_valid_elements(const QuadMesh& mesh);

/// Throws ComputeError with element, position and figure if an element has a lower scaled Jacobian than
/// `min_scaled_jacobian`, or a larger ratio of its sides than `max_edge_ratio` (mesh/element_sizes); 0: no limit.
void require_quality(const QuadMesh& mesh, double min_scaled_jacobian, double max_edge_ratio);

/// Reports the numbers of elements, nodes, blocks and irregular nodes, the sizes of elements and what report_validity
/// does.
void report_mesh(const QuadMesh& mesh, Report& report);

/// Reports the least bound, scaled Jacobian and ratio, the number of elements not proved valid, and the worst elements
/// (worst.1.*, ...).
void report_validity(const QuadMesh& mesh, Report& report);

}  // namespace quadrille::refine
