#include "galerkin/solve_parts.hpp"

#include "galerkin/continuous.hpp"
#include "spectral/modified_basis.hpp"

namespace quadrille::galerkin {
namespace {

/// Smaller coefficients are omitted: what they add up to is far below the error of any field.
constexpr double negligible = 1e-13;

field::HarmonicPart part_of(const ContinuousSystem& system, const Field& field, const Eigen::MatrixXd& dofs,
                            const std::vector<Lifting>& liftings) {
  field::HarmonicPart part;
  part.liftings = liftings;
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    const Eigen::MatrixXd modes = system.modes(e, dofs);
    if (modes.cwiseAbs().maxCoeff() < negligible) continue;
    const Eigen::MatrixXd coefs = spectral::modified_to_orthogonal(field.elem_order[e]).transpose() * modes;
    part.elems.push_back(e);
    part.u.insert(part.u.end(), coefs.col(0).begin(), coefs.col(0).end());
    part.v.insert(part.v.end(), coefs.col(1).begin(), coefs.col(1).end());
  }
  return part;
}

}  // namespace

std::vector<field::HarmonicPart> solve_parts(const Field& field, const std::vector<field::LiftedData>& data,
                                             int num_threads) {
  const MeshContext context(field.mesh);
  ContinuousSystem system(context, num_threads);
  Stopwatch watch;
  system.set_orders(field.elem_order, watch);
  const auto points = std::make_shared<BoundaryPoints>(field.mesh);
  std::vector<field::HarmonicPart> parts;
  for (const field::LiftedData& each : data) {
    DirichletData dirichlet(points, each.values);
    const Eigen::MatrixXd dofs = system.solve(dirichlet.values(context.topology, system.map()), watch);
    parts.push_back(part_of(system, field, dofs, each.liftings));
  }
  return parts;
}

}  // namespace quadrille::galerkin
