#include "growth/line_correction.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "growth/normal_equations.hpp"

namespace quadrille::growth {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct CorrectionConstants {
  double smallness = 0.02;  ///< corrections reach some seven intervals far; less lets them skew far blocks
  double weight_of_excess = 10;
  int max_corrections = 40;
  int full_corrections = 10;  ///< later ones move half as far, in case two alternate
  double small_change = 1e-9;
};
constexpr CorrectionConstants correction_constants;

/// Adjacent intervals of the line; -1: a layer.
struct Adjacent {
  int first = 0, second = 0;
  double log_ratio = 0;  ///< of the second one's size to the first one's
  double given = 0;      ///< correction of the layer
};

double correction(const VectorXd& c, int k, double given) { return k < 0 ? given : c[k]; }

std::vector<Adjacent> adjacent_intervals(const std::vector<LinePiece>& pieces, bool is_closed) {
  std::vector<Adjacent> pairs;
  const LinePiece* last = is_closed && !pieces.back().after ? &pieces.back() : nullptr;
  int first = 0, size = 0;
  for (const LinePiece& piece : pieces) size += static_cast<int>(piece.sizes.size());
  for (const LinePiece& piece : pieces) {
    const int count = static_cast<int>(piece.sizes.size());
    if (piece.before)
      pairs.push_back({-1, first, std::log(piece.sizes.front() / piece.before->size), piece.before->correction});
    else if (last && size > 1)
      pairs.push_back({first > 0 ? first - 1 : size - 1, first, std::log(piece.sizes.front() / last->sizes.back()), 0});
    for (int k = 0; k + 1 < count; ++k)
      pairs.push_back({first + k, first + k + 1, std::log(piece.sizes[k + 1] / piece.sizes[k]), 0});
    if (piece.after)
      pairs.push_back(
          {first + count - 1, -1, std::log(piece.after->size / piece.sizes.back()), piece.after->correction});
    last = piece.after ? nullptr : &piece;
    first += count;
  }
  return pairs;
}

/// The minimum without the constraints, linearised where pairs exceed the limit.
NormalEquations smoothness(const std::vector<Adjacent>& pairs, const VectorXd& c, double log_limit) {
  NormalEquations equations(static_cast<int>(c.size()));
  for (int k = 0; k < c.size(); ++k) equations.add(correction_constants.smallness, 0, {{k, 1}});
  for (const Adjacent& pair : pairs) {
    const double change = correction(c, pair.second, pair.given) - correction(c, pair.first, pair.given);
    const double growth = pair.log_ratio + change;
    // weight (c' - c - target)^2 is (c' - c)^2 + weight_of_excess (ln b' / b + c' - c -+ log_limit)^2 up to a constant.
    const double excess = std::abs(growth) > log_limit ? correction_constants.weight_of_excess : 0, weight = 1 + excess;
    const double target = excess * (std::copysign(log_limit, growth) - pair.log_ratio) / weight;
    const double fixed = (pair.second < 0 ? pair.given : 0) - (pair.first < 0 ? pair.given : 0);
    equations.add(weight, fixed - target, {{pair.first, -1}, {pair.second, 1}});
  }
  return equations;
}

/// The linearised logarithms of the pieces' sums: their derivatives are the shares of the intervals.
struct Constraints {
  MatrixXd shares;
  VectorXd target;
};

Constraints constraints(const std::vector<LinePiece>& pieces, const VectorXd& c) {
  const int num_pieces = static_cast<int>(pieces.size());
  Constraints result{MatrixXd::Zero(c.size(), num_pieces), VectorXd(num_pieces)};
  int k = 0;
  for (int p = 0; p < num_pieces; ++p) {
    const int first = k;
    double sum = 0;
    for (const double b : pieces[p].sizes) sum += result.shares(k, p) = b * std::exp(c[k]), ++k;
    result.shares.col(p) /= sum;
    result.target[p] = std::log(pieces[p].length / sum) +
                       result.shares.col(p).segment(first, k - first).dot(c.segment(first, k - first));
  }
  return result;
}

}  // namespace

std::vector<std::vector<double>> corrected_lengths(const std::vector<LinePiece>& pieces, bool is_closed, double limit) {
  int size = 0;
  for (const LinePiece& piece : pieces) size += static_cast<int>(piece.sizes.size());
  const std::vector<Adjacent> pairs = adjacent_intervals(pieces, is_closed);
  VectorXd c = VectorXd::Zero(size);
  for (int step = 0; step < correction_constants.max_corrections; ++step) {
    const NormalEquations smooth = smoothness(pairs, c, std::log(limit));
    const auto [shares, target] = constraints(pieces, c);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(smooth.matrix());
    const VectorXd free = solver.solve(smooth.right());
    const MatrixXd response = solver.solve(shares);
    const VectorXd forces =
        MatrixXd(shares.transpose() * response).ldlt().solve(target - VectorXd(shares.transpose() * free));
    const VectorXd next = free + response * forces;
    const double change = (next - c).cwiseAbs().maxCoeff();
    c += (step < correction_constants.full_corrections ? 1 : 0.5) * (next - c);
    if (change < correction_constants.small_change) break;
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
