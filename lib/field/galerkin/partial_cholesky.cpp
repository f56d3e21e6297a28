#include "galerkin/partial_cholesky.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace quadrille::galerkin {

namespace {

using Block = Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstBlock = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr int block_size = 128;

/// [a11; a21] := [L11; L21].
bool factor_columns(Block columns) {
  const int k = static_cast<int>(columns.cols()), below = static_cast<int>(columns.rows()) - k;
  Block top = columns.topRows(k);
  if (Eigen::LLT<Block>(top).info() != Eigen::Success) return false;
  if (below > 0) {
    top.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(columns.bottomRows(below));
  }
  return true;
}

/// a -= factors factors^T, where a contains `cols` columns of a lower triangle from its diagonal down.
void update(Block a, const ConstBlock& factors) {
  const int n = static_cast<int>(a.cols()), below = static_cast<int>(a.rows()) - n;
  a.topRows(n).selfadjointView<Eigen::Lower>().rankUpdate(factors.topRows(n), -1);
  if (below > 0) a.bottomRows(below).noalias() -= factors.bottomRows(below) * factors.topRows(n).transpose();
}

/// update() of a whole lower triangle `a` or of its first columns, column block by column block.
void update_blocks(Block a, const ConstBlock& factors, int num_threads) {
  const int rows = static_cast<int>(a.rows()), cols = static_cast<int>(a.cols());
  parallel_for((cols + block_size - 1) / block_size, num_threads, [&](int i) {
    const int first = i * block_size, width = std::min(block_size, cols - first);
    update(a.block(first, first, rows - first, width), factors.bottomRows(rows - first));
  });
}

}  // namespace

bool eliminate(Front& front, int num_threads) {
  const int rows = static_cast<int>(front.panel.rows()), cols = static_cast<int>(front.panel.cols());
  for (int first = 0; first < cols; first += block_size) {
    const int width = std::min(block_size, cols - first), next = first + width;
    Block columns = front.panel.block(first, first, rows - first, width);
    if (!factor_columns(columns)) return false;
    if (next < cols)
      update_blocks(front.panel.block(next, next, rows - next, cols - next), columns.bottomRows(rows - next),
                    num_threads);
  }
  if (cols > 0 && rows > cols) update_blocks(front.rest, front.panel.bottomRows(rows - cols), num_threads);
  return true;
}

}  // namespace quadrille::galerkin
