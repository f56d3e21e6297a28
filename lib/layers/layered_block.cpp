#include "layers/layered_block.hpp"

#include <algorithm>
#include <functional>

#include "mesh/transfinite.hpp"

namespace quadrille::layers {
namespace {

/// Interpolation of y over rising x by the polynomial of each element's nodes.
class PiecewisePolynomial {
 public:
  PiecewisePolynomial(std::vector<double> x, std::vector<double> y, int order)
      : x_(std::move(x)), y_(std::move(y)), order_(order) {}

  double operator()(double x) const {
    const std::size_t node = std::lower_bound(x_.begin(), x_.end(), x) - x_.begin();
    const std::size_t first = std::min((std::max<std::size_t>(node, 1) - 1) / order_ * order_, x_.size() - 1 - order_);
    double result = 0;
    for (int i = 0; i <= order_; ++i) {
      double basis = 1;
      for (int k = 0; k <= order_; ++k)
        if (k != i) basis *= (x - x_[first + k]) / (x_[first + i] - x_[first + k]);
      result += basis * y_[first + i];
    }
    return result;
  }

 private:
  std::vector<double> x_, y_;
  int order_;
};

/// A block whose nodes are being placed. Rows run along s, columns along t.
struct BlockNodes {
  const LayeredBlock& block;
  std::array<Vec2, 4> corners;
  int order;
  Vec2 origin;

  bool has_wall(int side) const { return block.sides[side].wall != nullptr; }
  int width() const { return static_cast<int>(block.fractions[0].size()); }
  int height() const { return static_cast<int>(block.fractions[1].size()); }
  int number(int i, int j) const { return j * width() + i; }

  /// The block's exact map (mesh/transfinite).
  Vec2 position(double s, double t) const {
    const std::array<SideTable, 4>& sides = block.tables;
    return mesh::blend_sides({sides[0].at(s), sides[1].at(t), sides[2].at(s), sides[3].at(t)}, corners, s, t);
  }

  /// Lengths of the elements on a side.
  std::vector<double> lengths(int side) const {
    const std::vector<double>& fractions = block.fractions[side];
    std::vector<double> result;
    for (std::size_t k = order; k < fractions.size(); k += order)
      result.push_back((fractions[k] - fractions[k - order]) * block.lengths[side]);
    return result;
  }

  /// t on row j, a straight line in (s, t).
  double row_t(int j, double s) const {
    const std::vector<double>&f3 = block.fractions[3], &f1 = block.fractions[1];
    return f3[j] + s * (f1[j] - f3[j]);
  }
};

void place_crossings(const BlockNodes& nodes, std::vector<Vec2>& positions) {
  const std::array<std::vector<double>, 4>& f = nodes.block.fractions;
  for (int j = 1; j + 1 < nodes.height(); ++j)
    for (int i = 1; i + 1 < nodes.width(); ++i) {
      const Vec2 st = mesh::crossing_parameters(f[0][i], f[1][j], f[2][i], f[3][j]);
      positions[nodes.number(i, j)] = nodes.position(st.x, st.y);
    }
}

/// Divides the rows between sides 3 and 1; returns s of every inner node.
std::vector<double> place_rows(const BlockNodes& nodes, std::vector<Vec2>& positions) {
  const LayeredBlock& block = nodes.block;
  const LineFamily family =
      line_family(block.sides[3], block.sides[1], nodes.lengths(0), nodes.lengths(2), nodes.order);
  std::vector<double> node_s(positions.size(), 0);
  for (int j = 1; j + 1 < nodes.height(); ++j) {
    const NormalLine row = [&](double s) { return nodes.position(s, nodes.row_t(j, s)); };
    const double blend = (block.fractions[3][j] + block.fractions[1][j]) / 2;
    const std::vector<double> s = divide_normal_line(family, row, j, blend, nodes.origin);
    for (int i = 1; i + 1 < nodes.width(); ++i) {
      node_s[nodes.number(i, j)] = s[i];
      positions[nodes.number(i, j)] = row(s[i]);
    }
  }
  return node_s;
}

/// s by t where column i crosses the rows.
PiecewisePolynomial row_crossings(const BlockNodes& nodes, const std::vector<double>& node_s, int i) {
  std::vector<double> s{nodes.block.fractions[0][i]}, t{0.0};
  for (int j = 1; j + 1 < nodes.height(); ++j) {
    s.push_back(node_s[nodes.number(i, j)]);
    t.push_back(nodes.row_t(j, s.back()));
  }
  s.push_back(nodes.block.fractions[2][i]), t.push_back(1);
  return {std::move(t), std::move(s), nodes.order};
}

/// Divides the columns between sides 0 and 2. `node_s`: as from place_rows, where columns run along the rows' nodes;
/// empty: they are straight in (s, t).
void place_columns(const BlockNodes& nodes, const std::vector<double>& node_s, std::vector<Vec2>& positions) {
  const LayeredBlock& block = nodes.block;
  const LineFamily family =
      line_family(block.sides[0], block.sides[2], nodes.lengths(3), nodes.lengths(1), nodes.order);
  for (int i = 1; i + 1 < nodes.width(); ++i) {
    const double s0 = block.fractions[0][i], s2 = block.fractions[2][i];
    std::function<double(double)> s = [s0, s2](double t) { return s0 + t * (s2 - s0); };
    if (!node_s.empty()) s = row_crossings(nodes, node_s, i);
    const NormalLine column = [&](double t) { return nodes.position(s(t), t); };
    const std::vector<double> t = divide_normal_line(family, column, i, (s0 + s2) / 2, nodes.origin);
    for (int j = 1; j + 1 < nodes.height(); ++j) positions[nodes.number(i, j)] = column(t[j]);
  }
}

}  // namespace

std::vector<Vec2> layered_positions(const LayeredBlock& block, int order, Vec2 origin) {
  const std::array<SideTable, 4>& sides = block.tables;
  const BlockNodes nodes{block, {sides[0].at(0), sides[0].at(1), sides[2].at(1), sides[2].at(0)}, order, origin};
  const bool has_rows = nodes.has_wall(1) || nodes.has_wall(3), has_columns = nodes.has_wall(0) || nodes.has_wall(2);
  std::vector<Vec2> positions(block.fractions[0].size() * block.fractions[1].size());
  std::vector<double> node_s;
  if (has_rows) node_s = place_rows(nodes, positions);
  if (has_columns) place_columns(nodes, node_s, positions);
  if (!has_rows && !has_columns) place_crossings(nodes, positions);
  return positions;
}

}  // namespace quadrille::layers
