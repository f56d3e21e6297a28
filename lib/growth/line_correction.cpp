#include "growth/line_correction.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <cmath>

namespace quadrille::growth {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double smallness = 0.02;  // corrections reach some seven intervals far; less lets them skew far blocks
constexpr int max_corrections = 20;
constexpr double small_change = 1e-9;

/// The matrix and the right side of the minimum without the constraints.
struct Smoothness {
  Eigen::SparseMatrix<double> matrix;
  VectorXd right;
};

Smoothness smoothness(const std::vector<LinePiece>& pieces, int size, bool is_closed) {
  std::vector<Eigen::Triplet<double>> entries;
  Smoothness result{{size, size}, VectorXd::Zero(size)};
  for (int k = 0; k < size; ++k) entries.emplace_back(k, k, smallness);
  const auto join = [&](int a, int b) {
    for (const auto& [i, j] : {std::pair{a, b}, std::pair{b, a}})
      entries.emplace_back(i, i, 1), entries.emplace_back(i, j, -1);
  };
  const auto hold = [&](int k, double value) {
    entries.emplace_back(k, k, 1);
    result.right[k] += value;
  };
  int first = 0;
  for (const LinePiece& piece : pieces) {
    const int last = first + static_cast<int>(piece.sizes.size()) - 1;
    for (int k = first; k < last; ++k) join(k, k + 1);
    if (piece.before) hold(first, *piece.before);
    if (piece.after)
      hold(last, *piece.after);
    else if (last + 1 < size)
      join(last, last + 1);
    else if (is_closed && size > 1)
      join(last, 0);
    first = last + 1;
  }
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

std::vector<std::vector<double>> corrected_lengths(const std::vector<LinePiece>& pieces, bool is_closed) {
  int size = 0;
  for (const LinePiece& piece : pieces) size += static_cast<int>(piece.sizes.size());
  const int num_pieces = static_cast<int>(pieces.size());
  const Smoothness smooth = smoothness(pieces, size, is_closed);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(smooth.matrix);
  const VectorXd free = solver.solve(smooth.right);
  VectorXd c = VectorXd::Zero(size);
  for (int step = 0; step < max_corrections; ++step) {
    // The logarithm of each sum is linearised: its derivatives are the shares of the intervals.
    MatrixXd shares = MatrixXd::Zero(size, num_pieces);
    VectorXd target(num_pieces);
    int k = 0;
    for (int p = 0; p < num_pieces; ++p) {
      const int first = k;
      double sum = 0;
      for (const double b : pieces[p].sizes) sum += shares(k, p) = b * std::exp(c[k]), ++k;
      shares.col(p) /= sum;
      target[p] =
          std::log(pieces[p].length / sum) + shares.col(p).segment(first, k - first).dot(c.segment(first, k - first));
    }
    const MatrixXd response = solver.solve(shares);
    const VectorXd forces =
        MatrixXd(shares.transpose() * response).ldlt().solve(target - VectorXd(shares.transpose() * free));
    const VectorXd next = free + response * forces;
    const double change = (next - c).cwiseAbs().maxCoeff();
    c = next;
    if (change < small_change) break;
  }
  std::vector<std::vector<double>> lengths;
  int k = 0;
  for (const LinePiece& piece : pieces) {
    lengths.emplace_back();
    for (const double b : piece.sizes) lengths.back().push_back(b * std::exp(c[k++]));
  }
  return lengths;
}

}  // namespace quadrille::growth
