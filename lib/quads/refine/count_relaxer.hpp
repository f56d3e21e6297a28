#pragma once
// The mesh that other counts of chords would give, without making it: each element of a relaxed mesh stands for k x l
// elements, or parts of one, and its vertices are relaxed again (refine/relax_sizes) to k h and l h in place of the
// prescribed length h. On 30 shapes its resolution ratio is that of the mesh which is then made to some 2 %.

#include <vector>

#include "refine/size_relaxer.hpp"

namespace quadrille::refine {

class CountRelaxer {
 public:
  /// `mesh`: relaxed, its edges inside shaped. Its vertices at joints that vertices may slide off stay.
  CountRelaxer(const QuadMesh& mesh, SizeRelaxation options);

  /// The mesh with its vertices moved, from where they were kept last, and straight sides: of order 1. `counts`, by
  /// element: k and l. Of scaled Jacobians it has those at corners.
  const QuadMesh& moved(std::vector<Vec2> counts);
  const QuadMesh& mesh() const { return mesh_; }
  /// Of the mesh that was moved last, with the sizes prescribed where its elements are; sides on curves are curved.
  mesh::Resolution resolution(const sizing::SizeField& sizes, const std::vector<Vec2>& greatest_lengths);
  /// Vertices begin the next move where the last one ended.
  void keep() { kept_ = relaxer_.moves; }
  PlacedVertices kept() const { return {problem_, kept_}; }

 private:
  const SizeRelaxation options_;
  RelaxProblem problem_;
  SizeRelaxer relaxer_;
  VertexMoves kept_;
  QuadMesh mesh_;
};

}  // namespace quadrille::refine
