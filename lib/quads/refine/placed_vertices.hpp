#pragma once
// Where the vertices of a mesh are, so that those of another mesh of the same blocks, with other counts or the same,
// can begin there: relaxation then takes fewer steps.

#include <vector>

#include "refine/relax_problem.hpp"

namespace quadrille::refine {

/// The vertices of one block's grid, along side 0 fastest.
struct VertexGrid {
  int block = 0;
  int columns = 0, rows = 0;  ///< elements along sides 0 and 1
  std::vector<int> vertices;  ///< (columns + 1) x (rows + 1)

  int at(int column, int row) const { return vertices[row * (columns + 1) + column]; }
};

/// Of all blocks, ascending.
std::vector<VertexGrid> block_vertices(const RelaxProblem& problem);

class PlacedVertices {
 public:
  PlacedVertices(const RelaxProblem& problem, const VertexMoves& moves);

  /// The moves by which the vertices of another mesh of these blocks get to the same fractions of the lines of their
  /// blocks, linear between vertices; on the boundary by length. Vertices that are fixed there do not move.
  VertexMoves moves(const RelaxProblem& problem) const;

 private:
  struct Place {
    Vec2 position;
    int loop = -1;      ///< on the boundary
    double length = 0;  ///< along it
  };
  struct Grid {
    int columns = 0, rows = 0;
    std::vector<Place> places;
  };
  /// A vertex of a line and the part of the way to the next one.
  struct OnLine {
    int low = 0;
    double part = 0;
  };
  static OnLine on_line(int index, int count, int other_count);
  static Place place(const RelaxProblem& problem, int vertex, Vec2 start, Vec2 move);
  Vec2 move(const RelaxProblem& problem, const Place& from, const Grid& grid, OnLine s, OnLine t) const;

  std::vector<Grid> grids_;  ///< by block; empty: none
};

}  // namespace quadrille::refine
