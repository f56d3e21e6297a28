#include "galerkin/phase_gradient.hpp"

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "field/phase_value.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::galerkin {

mesh::Location locate_node(const mesh::Locator& locator, const TriMesh& mesh, Vec2 node) {
  const mesh::Location at = locator.find(node);
  if (at.elem >= 0) return at;
  throw ComputeError("the irregular node at " + position_text(node + mesh.face.origin) + " is outside the mesh");
}

Vec2 remainder_gradient(const spectral::TriMap& map, Vec2 xi, int order, const double* coefs) {
  Vec2 x;
  Mat2 dx_dxi, ds_dxi;
  map.evaluate(xi, x, dx_dxi);
  spectral::orthogonal_sum(order, coefs, coefs, xi, ds_dxi);
  const Mat2 ds_dx = ds_dxi * inverse(dx_dxi);
  return {ds_dx.xx, ds_dx.xy};
}

Vec2 phase_energy_gradient(const PhaseTerms& terms, int k, Vec2 remainder_slope) {
  const PhaseTurn node = terms.nodes[k];
  PhaseTerms others = terms;
  others.nodes.erase(others.nodes.begin() + k);
  const Vec2 slope = remainder_slope + field::explicit_phase_gradient(others, node.position);
  return -2 * pi * node.turns * Vec2{slope.y, -slope.x};
}

}  // namespace quadrille::galerkin
