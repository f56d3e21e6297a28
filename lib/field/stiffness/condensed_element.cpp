#include "stiffness/condensed_element.hpp"

#include <utility>

#include "spectral/factored_modes.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "stiffness/element_matrices.hpp"
#include "stiffness/harmonic_coefs.hpp"
#include "stiffness/harmonic_element.hpp"

namespace quadrille::stiffness {

CondensedElement condensed_element(const spectral::TriMap& map, int order) {
  if (order >= least_harmonic_order) {
    std::optional<HarmonicElement> harmonic = harmonic_element(map, order);
    if (harmonic) return {std::move(harmonic->schur), std::nullopt, std::move(harmonic->projection)};
  }
  return condense(order, stiffness_matrix(map, order));
}

Eigen::MatrixXd element_coefs(const spectral::TriMap& map, int order, const CondensedElement& element,
                              const Eigen::MatrixXd& boundary) {
  if (!element.interior) return harmonic_coefs(map, order, element.projection, boundary);
  Eigen::MatrixXd modes(spectral::num_tri_modes(order), boundary.cols());
  modes << boundary, *element.interior * boundary;
  return spectral::modified_to_orthogonal(order).transpose() * modes;
}

std::size_t size_of_interior(const CondensedElement& element) {
  const auto size = [](const Eigen::MatrixXd& matrix) { return static_cast<std::size_t>(matrix.size()); };
  return size(element.interior ? *element.interior : element.projection);
}

}  // namespace quadrille::stiffness
