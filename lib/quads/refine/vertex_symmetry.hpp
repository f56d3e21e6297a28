#pragma once
// The symmetries of a mesh whose vertices move: what is symmetric is moved symmetrically, however often rounding errors
// are multiplied.

#include <vector>

#include "curve/symmetry.hpp"
#include "refine/relax_problem.hpp"

namespace quadrille::refine {

class VertexSymmetry {
 public:
  /// The isometries of the face that map these positions of the vertices onto each other (within 1e-6 diameters), and
  /// the gradient of the energy there onto itself (within a hundredth of it). O(n) for n vertices.
  /// `tangents`: of the curves at vertices that slide.
  VertexSymmetry(const RelaxProblem& problem, const std::vector<Vec2>& positions, const std::vector<Vec2>& tangents,
                 const VertexMoves& gradient);

  /// Replaces a gradient, or moves, by the mean over all images.
  void average(VertexMoves& moves) const;

 private:
  struct Image {
    std::vector<int> vertex;         ///< by vertex: its image
    Vec2 x, y;                       ///< the directions that are mapped onto those of the axes
    std::vector<bool> is_backwards;  ///< by vertex that slides: its image slides in the opposite direction
  };
  Vec2 back(const Image& image, int vertex, const VertexMoves& moves) const;

  const RelaxProblem& problem_;
  std::vector<Image> images_;  ///< without the identity
};

}  // namespace quadrille::refine
