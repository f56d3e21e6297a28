#pragma once
// The energy that relaxation minimises: the deviation of elements from their prescribed shape.
//
// At each node of an element, a = x_xi1 / l1 and b = x_xi2 / l2 are the derivatives of its map over their lengths in
// the mesh as it was, and mu = (|a|^2 + |b|^2) / (2 a x b) >= 1 is least where they are normal to each other and keep
// the proportion of the prescribed edge lengths; it has no bound where det J tends to 0 (Knupp 2001, shape metric with
// targets). The energy is the mean over nodes of mu^p, summed over elements: the power gives the worst elements the
// largest weight.

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::refine {

/// Energy of one element, its gradient by the shifts of the corners and a positive definite part of the Hessian's
/// diagonal blocks (xx, xy, yy), when nodes follow corners bilinearly.
struct ElementEnergy {
  double value = 0;
  std::array<Vec2, 4> gradient;
  std::array<std::array<double, 3>, 4> hessian{};
};

class ShapeEnergy {
 public:
  /// Reference lengths are computed from the present `mesh`.
  explicit ShapeEnergy(const QuadMesh& mesh);

  /// Infinite if det J is not positive at a node.
  double value(int elem, const std::vector<Vec2>& nodes) const;
  ElementEnergy with_derivatives(int elem, const std::vector<Vec2>& nodes) const;

 private:
  struct Jacobians {
    Eigen::MatrixXd x1, x2, y1, y2;  ///< row: xi1, column: xi2
  };
  Jacobians jacobians(int elem, const std::vector<Vec2>& nodes) const;

  int order_;
  std::vector<int> elem_nodes_;
  Eigen::MatrixXd derivative_;
  std::vector<Vec2> inverse_lengths_;  ///< 1 / l1, 1 / l2 at each node of each element
};

}  // namespace quadrille::refine
