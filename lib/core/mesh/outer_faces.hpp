#pragma once
// What is seen of a hexahedral mesh: its outer faces, as a quad mesh in space. Lines between blocks or groups.

#include <vector>

#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::mesh {

struct ElementSide {
  int elem = 0, side = 0;
};

/// A side between two elements of different groups, from the lower element and from the other one.
struct Border {
  ElementSide first, second;
};
std::vector<Border> borders(const QuadMesh& mesh, const std::vector<int>& elem_group);

/// The faces of all groups but interfaces, each with its nodes in order, the block and the figures of its element; an
/// edge between two groups is a boundary edge, `curve` the number of its own group. `nodes` are all (0, 0): the quads
/// have positions in space alone.
QuadMesh outer_faces(const HexMesh& mesh);

}  // namespace quadrille::mesh
