#pragma once
// The nodes on the arcs of a layout, common to the blocks on both sides.

#include <array>
#include <vector>

#include "layers/wall_layers.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/arc_division.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

/// The nodes of an arc or of a block's side: the Gauss-Lobatto-Legendre points of every interval, ends shared.
struct ArcNodes {
  std::vector<double> fractions;  ///< of the arc's length, ascending from 0 to 1
  std::vector<int> ids;           ///< in the mesh
};

/// Appends the inner nodes of one arc to the mesh, which begins with the nodes of the layout. In the arc's own
/// direction; with `walls` an arc that starts at a wall has the nodes of its layers.
ArcNodes place_on_arc(const sizing::MeasuredLayout& measured, int arc, const sizing::ArcDivision& division,
                      const layers::WallPlan* walls, QuadMesh& mesh);

/// The sides of a block, each in the direction of rising s (sides 0, 2) or t (sides 1, 3). `arc_nodes` by arc.
std::array<ArcNodes, 4> side_nodes(const BlockLayout& layout, int block, const std::vector<ArcNodes>& arc_nodes);

}  // namespace quadrille::refine
