#include "galerkin/solve_parts.hpp"

#include <algorithm>

namespace quadrille::galerkin {
namespace {

/// Smaller coefficients are omitted: what they add up to is far below the error of any field.
constexpr double negligible = 1e-13;

/// Functions that are solved for together: wide matrices are faster, but take memory.
constexpr std::size_t batch = 8;

/// Adds what each part is on element e, from two columns of `coefs` for each.
void add_element(const Eigen::MatrixXd& coefs, int e, field::HarmonicPart* parts) {
  for (int k = 0; 2 * k < coefs.cols(); ++k) {
    if (coefs.middleCols(2 * k, 2).cwiseAbs().maxCoeff() < negligible) continue;
    parts[k].elems.push_back(e);
    parts[k].u.insert(parts[k].u.end(), coefs.col(2 * k).begin(), coefs.col(2 * k).end());
    parts[k].v.insert(parts[k].v.end(), coefs.col(2 * k + 1).begin(), coefs.col(2 * k + 1).end());
  }
}

}  // namespace

std::vector<field::HarmonicPart> solve_parts(const MeshContext& context, ContinuousSystem& system,
                                             const std::shared_ptr<BoundaryPoints>& points,
                                             const std::vector<field::LiftedData>& data) {
  const std::vector<int>& elem_order = system.elem_order();
  Stopwatch watch;
  std::vector<field::HarmonicPart> parts(data.size());
  for (std::size_t first = 0; first < data.size(); first += batch) {
    const std::size_t last = std::min(first + batch, data.size());
    Eigen::MatrixXd given(system.map().num_dofs - system.map().num_unknowns, 2 * (last - first));
    for (std::size_t i = first; i < last; ++i) {
      parts[i].liftings = data[i].liftings;
      given.middleCols(2 * (i - first), 2) =
          DirichletData(points, data[i].values).values(context.topology, system.map());
    }
    const Eigen::MatrixXd dofs = system.solve(given, watch);
    for (int e = 0; e < static_cast<int>(elem_order.size()); ++e) add_element(system.coefs(e, dofs), e, &parts[first]);
  }
  return parts;
}

}  // namespace quadrille::galerkin
