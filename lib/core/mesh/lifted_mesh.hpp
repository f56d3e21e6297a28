#pragma once
// The quad mesh of a curved face in space: its nodes lifted to the surface, and how far its elements are from that.

#include <vector>

#include "mesh/chart_map.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

/// Fills in space_nodes: points of the exact surface; nodes on boundary and interface edges are points of the curves in
/// space, with the parameters that they have in the chart; those within 1e-8 diameters of a joint move there, and those
/// on the second of two periodic curves are the images of those on the first. Measures are to be taken again.
void lift_nodes(const ChartMap& map, QuadMesh& mesh);

/// Distances of the elements from the surface, and of their edges on the boundary from the curves in space.
struct SurfaceDistance {
  std::vector<double> elem;  ///< greatest of each element
  int worst_elem = 0;
  Vec2 position;  ///< where it is greatest, in the chart, relative to face.origin

  double worst() const { return elem[worst_elem]; }
};

/// Of a lifted mesh, in the middles between the nodes of each element and of each edge on the boundary, where the
/// difference of a polynomial from what it interpolates is greatest.
SurfaceDistance surface_distance(const ChartMap& map, const QuadMesh& mesh);

}  // namespace quadrille::mesh
