#pragma once
// The vertices along the lines of a block of a mesh.

#include <algorithm>
#include <cstddef>

#include "model/quad_mesh.hpp"

namespace quadrille::growth {

class BlockVertices {
 public:
  /// `first`: the block's first element.
  BlockVertices(const QuadMesh& mesh, std::size_t first, int columns) : mesh_(mesh), first_(first), columns_(columns) {}

  /// Vertex k of column (direction 0) or row (1) `node`, a number of nodes.
  Vec2 at(int direction, int node, int k) const {
    return direction == 0 ? position(node, k * mesh_.order) : position(k * mesh_.order, node);
  }

 private:
  /// Node number i along side 0, j along side 1.
  Vec2 position(int i, int j) const {
    const int order = mesh_.order, width = order + 1;
    const int column = std::min(i / order, columns_ - 1), row = std::max(0, (j - 1) / order);
    const std::size_t elem = first_ + static_cast<std::size_t>(row) * columns_ + column;
    return mesh_.nodes[mesh_.elem_nodes[elem * width * width + (j - row * order) * width + i - column * order]];
  }

  const QuadMesh& mesh_;
  std::size_t first_;
  int columns_;
};

}  // namespace quadrille::growth
