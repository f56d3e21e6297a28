#pragma once
// A preconditioner for moves of vertices: moves that many neighbours have in common are found in as many steps in a
// fine mesh as in a coarse one.
//
// A level has every second line of the grid of each block of the level before, and what vertices between these lines
// move is linear between their neighbours on them. The inverse Hessian is approximated by the sum over all levels of
// the inverses of its diagonal blocks (Bramble, Pasciak, Xu 1990), which in the plane are about the same on all levels.

#include <array>
#include <vector>

#include "refine/relax_problem.hpp"

namespace quadrille::refine {

/// By vertex: the parts xx, xy, yy of a symmetric matrix.
using DiagonalBlocks = std::vector<std::array<double, 3>>;

class CoarseMoves {
 public:
  /// `problem` must outlive it.
  explicit CoarseMoves(const RelaxProblem& problem);

  /// Of the Hessian, positive definite; of vertices that slide the first part is that along their `tangents`.
  void set_blocks(const DiagonalBlocks& blocks, const std::vector<Vec2>& tangents);

  /// The approximate inverse Hessian times a gradient. O(n) for n vertices.
  VertexMoves operator()(const VertexMoves& gradient) const;

 private:
  /// Of a vertex that the next level does not have to one that it has.
  struct Link {
    int vertex = 0, leader = 0;
    double weight = 0;
  };
  struct Level {
    std::vector<int> vertices;
    std::vector<Link> links;  ///< vertex by vertex
  };
  struct BlockGrid {
    std::vector<int> vertices;  ///< along side 0 fastest
    int width = 0;
    std::vector<int> columns, rows;  ///< lines of the present level
  };

  void add_level(std::vector<BlockGrid>& grids);

  const RelaxProblem& problem_;
  std::vector<Level> levels_;
  DiagonalBlocks inverse_;  ///< in x and y; 0 for vertices that are fixed
  std::vector<Vec2> tangents_;
};

}  // namespace quadrille::refine
