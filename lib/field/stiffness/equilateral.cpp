#include "stiffness/equilateral.hpp"

#include <array>
#include <cmath>

#include "spectral/factored_modes.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "stiffness/condense.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::stiffness {
namespace {

Equilateral make_equilateral(int order) {
  const spectral::TriMap map(std::array{Vec2{0, 0}, Vec2{1, 0}, Vec2{0.5, std::sqrt(0.75)}});
  const CondensedElement element = condense(order, stiffness_matrix(map, order));
  const int nb = spectral::num_boundary_modes(order);
  Eigen::MatrixXd modes(spectral::num_tri_modes(order), nb);
  modes << Eigen::MatrixXd::Identity(nb, nb), *element.interior;
  return {element.schur.dense().diagonal().cwiseSqrt(), spectral::modified_to_orthogonal(order).transpose() * modes};
}

}  // namespace

const Equilateral& equilateral(int order) {
  static spectral::PerOrder<Equilateral> tables(make_equilateral);
  return tables[order];
}

}  // namespace quadrille::stiffness
