#include "galerkin/phase_energy.hpp"

#include <fmt/format.h>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "field/phase_terms.hpp"
#include "mesh/locate.hpp"
#include "mesh/tri_maps.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille {

namespace {

// Gradient of s.
Vec2 remainder_gradient(const PhaseSolution& solution, const TriMap& map, const Location& at) {
  Vec2 x;
  Mat2 dx_dxi, ds_dxi;
  map.evaluate(at.xi, x, dx_dxi);
  const double* s = &solution.s[solution.coef_offsets[at.elem]];
  orthogonal_sum(solution.elem_order[at.elem], s, s, at.xi, ds_dxi);
  const Mat2 ds_dx = ds_dxi * inverse(dx_dxi);
  return {ds_dx.xx, ds_dx.xy};
}

}  // namespace

std::vector<Vec2> phase_energy_gradient(const TriMesh& mesh, const PhaseSolution& solution) {
  const std::vector<TriMap> maps = tri_maps(mesh);
  const Locator locator(mesh, maps);
  std::vector<Vec2> gradient;
  for (std::size_t k = 0; k < solution.terms.nodes.size(); ++k) {
    const PhaseTurn node = solution.terms.nodes[k];
    const Location at = locator.find(node.position);
    if (at.elem < 0) {
      const Vec2 x = node.position + mesh.face.origin;
      throw ComputeError(fmt::format("the irregular node at ({:.6g}, {:.6g}) is outside the mesh", x.x, x.y));
    }
    PhaseTerms others = solution.terms;
    others.nodes.erase(others.nodes.begin() + static_cast<std::ptrdiff_t>(k));
    const Vec2 slope = remainder_gradient(solution, maps[at.elem], at) + explicit_phase_gradient(others, node.position);
    gradient.push_back(-2 * pi * node.turns * Vec2{slope.y, -slope.x});
  }
  return gradient;
}

}  // namespace quadrille
