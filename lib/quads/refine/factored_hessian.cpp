#include "refine/factored_hessian.hpp"

#include <algorithm>

namespace quadrille::refine {
namespace {

constexpr double least_diagonal = 1e-9;  ///< over the entry itself, that is added: a face may turn without a change

}  // namespace

void FactoredHessian::set(const std::vector<ElementHessian>& hessians, const SizeEnergy& energy) {
  std::vector<Eigen::Triplet<double>> entries;
  const int num_unknowns = 2 * problem_.num_vertices();
  for (std::size_t elem = 0; elem < hessians.size(); ++elem) {
    if (!energy.is_free(static_cast<int>(elem))) continue;
    const auto& vertices = problem_.follow.elem_vertices()[elem];
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) {
        const int row = problem_.slides_with(vertices[i / 2]), column = problem_.slides_with(vertices[j / 2]);
        const double sign = (row == vertices[i / 2]) == (column == vertices[j / 2]) ? 1 : -1;
        if (2 * row + i % 2 >= 2 * column + j % 2)
          entries.emplace_back(2 * row + i % 2, 2 * column + j % 2, sign * hessians[elem](i, j));
      }
  }
  for (int k = 0; k < num_unknowns; ++k) entries.emplace_back(k, k, 0);
  Eigen::SparseMatrix<double> matrix(num_unknowns, num_unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  for (int k = 0; k < num_unknowns; ++k) {
    double& diagonal = matrix.coeffRef(k, k);
    const bool is_fixed = problem_.is_fixed[k / 2] || diagonal == 0;
    diagonal = is_fixed ? 1 : diagonal * (1 + least_diagonal);
  }
  if (!has_pattern_) factors_.analyzePattern(matrix);
  has_pattern_ = true;
  factors_.factorize(matrix);
}

VertexMoves FactoredHessian::operator()(const VertexMoves& gradient) const {
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * problem_.num_vertices());
  for (int v = 0; v < problem_.num_vertices(); ++v) {
    if (problem_.is_fixed[v]) continue;
    const int u = problem_.slides_with(v);
    right[2 * u] += u == v ? gradient[v].x : -gradient[v].x;
    if (u == v) right[2 * u + 1] = gradient[v].y;
  }
  const Eigen::VectorXd solution = factors_.solve(right);
  VertexMoves moves(gradient.size());
  for (int v = 0; v < problem_.num_vertices(); ++v) {
    if (problem_.is_fixed[v]) continue;
    const int u = problem_.slides_with(v);
    moves[v] = u == v ? Vec2{solution[2 * u], solution[2 * u + 1]} : Vec2{-solution[2 * u], 0};
  }
  return moves;
}

}  // namespace quadrille::refine
