#pragma once
// How many elements a quad mesh has along each boundary and interface, and how long they are there.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

/// The edges of elements on the curves of one name; of an interface or an open curve, those of one side.
struct BoundaryElements {
  std::string name;
  int count = 0;
  double least_edge = 0, greatest_edge = 0;  ///< from end to end, in space if the mesh has nodes there
};

/// In the order of the first curve of each name; names without an edge are left out. O(n log n) for n edges.
std::vector<BoundaryElements> boundary_elements(const QuadMesh& mesh);

/// Reports boundaries.<n>.name, .elements, .least_edge and .greatest_edge.
void report_boundary_elements(const QuadMesh& mesh, Report& report);

}  // namespace quadrille::mesh
