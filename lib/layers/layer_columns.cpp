#include "layers/layer_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "layers/column.hpp"
#include "mesh/transfinite.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

/// Lengths of the elements on a side, from the fractions of its nodes.
std::vector<double> element_lengths(const std::vector<double>& fractions, double length, int order) {
  std::vector<double> lengths;
  for (std::size_t k = order; k < fractions.size(); k += order)
    lengths.push_back((fractions[k] - fractions[k - order]) * length);
  return lengths;
}

/// The intervals times e^(tilt weight), such that they sum to `total`.
std::vector<double> tilted(const std::vector<double>& intervals, const std::vector<double>& weights, double total) {
  const auto sum = [&](double tilt) {
    double result = 0;
    for (std::size_t i = 0; i < intervals.size(); ++i) result += intervals[i] * std::exp(tilt * weights[i]);
    return result;
  };
  double low = -5, high = 5;
  for (int step = 0; step < 60; ++step) {
    const double tilt = (low + high) / 2;
    (sum(tilt) < total ? low : high) = tilt;
  }
  const double tilt = (low + high) / 2, factor = total / sum(tilt);
  std::vector<double> result;
  for (std::size_t i = 0; i < intervals.size(); ++i)
    result.push_back(intervals[i] * std::exp(tilt * weights[i]) * factor);
  return result;
}

double speed_at(const ColumnCurve& curve, double u) {
  constexpr double step = 1e-4;
  const double low = std::max(0.0, u - step), high = std::min(1.0, u + step);
  return distance(curve(low), curve(high)) / (high - low);
}

/// Shares of the nodes of elements with these lengths, from 0 to 1.
std::vector<double> node_shares(const std::vector<double>& lengths, int order) {
  const std::vector<double>& gll = spectral::gll_points(order);
  double total = 0, low = 0;
  for (const double length : lengths) total += length;
  std::vector<double> shares{0.0};
  for (const double length : lengths) {
    for (int i = 1; i <= order; ++i) shares.push_back((low + length * (1 + gll[i]) / 2) / total);
    low += length;
  }
  shares.back() = 1;
  return shares;
}

/// All columns between two opposite sides: side `low` at u = 0, `high` at u = 1; `left` and `right` beside them.
struct Family {
  const SideLayers &low, &high;
  std::vector<double> left, right;  ///< element lengths
  int order = 1;
};

class ColumnDivider {
 public:
  ColumnDivider(const Family& family, Vec2 origin) : family_(family), origin_(origin) {
    low_heights_ = node_heights(family.low.heights, family.order);
    high_heights_ = node_heights(family.high.heights, family.order);
  }

  /// Parameters of the nodes of the column that starts at the given node of both sides; `blend` is 0 at the left.
  std::vector<double> divide(const ColumnCurve& curve, std::size_t node, double blend) const {
    std::vector<double> nodes{0.0};
    if (family_.low.wall) append(nodes, at_heights(curve, family_.low, low_heights_, node));
    std::vector<double> top{1.0};
    if (family_.high.wall) {
      const ColumnCurve reversed = [&curve](double u) { return curve(1 - u); };
      for (const double u : at_heights(reversed, family_.high, high_heights_, node)) top.push_back(1 - u);
      std::reverse(top.begin(), top.end());
    }
    if (nodes.back() >= top.front()) fail(curve(nodes.back()));
    append(nodes, rest(curve, nodes.back(), top.front(), blend));
    append(nodes, {top.begin() + 1, top.end()});
    return nodes;
  }

 private:
  static void append(std::vector<double>& to, const std::vector<double>& more) {
    to.insert(to.end(), more.begin(), more.end());
  }

  std::vector<double> at_heights(const ColumnCurve& curve, const SideLayers& side, const std::vector<double>& heights,
                                 std::size_t node) const {
    std::vector<double> u = parameters_at_heights(curve, *side.wall, side.feet[node], heights);
    if (u.size() < heights.size()) fail(curve(0));
    return u;
  }

  /// The nodes above the lower layers, up to where the upper ones begin: by u, which measures length on the arcs
  /// beside the column, and on it too but for a factor. So columns go over into the arcs to the last digit.
  std::vector<double> rest(const ColumnCurve& curve, double low, double high, double blend) const {
    const std::size_t first = family_.low.heights.size(), last = family_.left.size() - family_.high.heights.size();
    const bool from_low = family_.low.wall != nullptr, from_high = family_.high.wall != nullptr;
    const double low_speed = speed_at(curve, low), high_speed = speed_at(curve, high);
    const double count = static_cast<double>(last - first + 1);
    std::vector<double> intervals, weights;
    for (std::size_t k = first; k < last; ++k) {
      const double i = static_cast<double>(k - first + 1);
      const double x = !from_high ? 0 : !from_low ? 1 : i / count;
      intervals.push_back(std::pow(family_.left[k], 1 - blend) * std::pow(family_.right[k], blend) /
                          (std::pow(low_speed, 1 - x) * std::pow(high_speed, x)));
      weights.push_back(!from_high ? i : !from_low ? count - i : 2 * i * (count - i) / count);
    }
    std::vector<double> nodes;
    for (const double share : node_shares(tilted(intervals, weights, high - low), family_.order))
      nodes.push_back(low + share * (high - low));
    nodes.erase(nodes.begin());
    return nodes;
  }

  [[noreturn]] void fail(Vec2 place) const {
    throw ComputeError(fmt::format("the layers do not fit into the block beside the wall at ({:.6g}, {:.6g})",
                                   place.x + origin_.x, place.y + origin_.y));
  }

  const Family& family_;
  Vec2 origin_;
  std::vector<double> low_heights_, high_heights_;
};

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

class Placer {
 public:
  Placer(const LayeredBlock& block, int order, Vec2 origin)
      : block_(block),
        corners_{block.tables[0].at(0), block.tables[0].at(1), block.tables[2].at(1), block.tables[2].at(0)},
        order_(order),
        origin_(origin) {}

  std::vector<Vec2> place() {
    const bool across_t = has_wall(0) || has_wall(2), across_s = has_wall(1) || has_wall(3);
    if (across_s) place_rows();
    if (across_t) place_columns(across_s);
    if (!across_s && !across_t) place_crossings();
    return std::move(positions_);
  }

 private:
  /// The block's exact map (mesh/transfinite).
  Vec2 position(double s, double t) const {
    const std::array<SideTable, 4>& sides = block_.tables;
    return mesh::blend_sides({sides[0].at(s), sides[1].at(t), sides[2].at(s), sides[3].at(t)}, corners_, s, t);
  }

  bool has_wall(int side) const { return block_.sides[side].wall != nullptr; }
  int width() const { return static_cast<int>(block_.fractions[0].size()); }
  int height() const { return static_cast<int>(block_.fractions[1].size()); }
  std::vector<double> lengths(int side) const {
    return element_lengths(block_.fractions[side], block_.lengths[side], order_);
  }

  void place_crossings() {
    positions_.resize(width() * height());
    for (int j = 1; j + 1 < height(); ++j)
      for (int i = 1; i + 1 < width(); ++i) {
        const Vec2 st = mesh::crossing_parameters(block_.fractions[0][i], block_.fractions[1][j],
                                                  block_.fractions[2][i], block_.fractions[3][j]);
        positions_[j * width() + i] = position(st.x, st.y);
      }
  }

  /// Along the rows: s of every inner node, and positions, with t on the straight line between the ends.
  void place_rows() {
    const std::vector<double>&f3 = block_.fractions[3], &f1 = block_.fractions[1];
    const Family family{block_.sides[3], block_.sides[1], lengths(0), lengths(2), order_};
    const ColumnDivider divider(family, origin_);
    positions_.resize(width() * height());
    s_.assign(width() * height(), 0);
    for (int j = 1; j + 1 < height(); ++j) {
      const auto t = [&](double s) { return f3[j] + s * (f1[j] - f3[j]); };
      const ColumnCurve row = [&](double s) { return position(s, t(s)); };
      const std::vector<double> s = divider.divide(row, j, (f3[j] + f1[j]) / 2);
      for (int i = 1; i + 1 < width(); ++i) {
        s_[j * width() + i] = s[i];
        positions_[j * width() + i] = row(s[i]);
      }
    }
  }

  void place_columns(bool along_rows) {
    const Family family{block_.sides[0], block_.sides[2], lengths(3), lengths(1), order_};
    const ColumnDivider divider(family, origin_);
    positions_.resize(width() * height());
    for (int i = 1; i + 1 < width(); ++i) {
      const double s0 = block_.fractions[0][i], s2 = block_.fractions[2][i];
      std::function<double(double)> s = [s0, s2](double t) { return s0 + t * (s2 - s0); };
      if (along_rows) s = row_crossings(i);
      const ColumnCurve column = [&](double t) { return position(s(t), t); };
      const std::vector<double> t = divider.divide(column, i, (s0 + s2) / 2);
      for (int j = 1; j + 1 < height(); ++j) positions_[j * width() + i] = column(t[j]);
    }
  }

  /// s by t where column i crosses the rows.
  PiecewisePolynomial row_crossings(int i) const {
    const std::vector<double>&f3 = block_.fractions[3], &f1 = block_.fractions[1];
    std::vector<double> s{block_.fractions[0][i]}, t{0.0};
    for (int j = 1; j + 1 < height(); ++j) {
      s.push_back(s_[j * width() + i]);
      t.push_back(f3[j] + s.back() * (f1[j] - f3[j]));
    }
    s.push_back(block_.fractions[2][i]), t.push_back(1);
    return {std::move(t), std::move(s), order_};
  }

  const LayeredBlock& block_;
  std::array<Vec2, 4> corners_;
  int order_;
  Vec2 origin_;
  std::vector<Vec2> positions_;
  std::vector<double> s_;
};

}  // namespace

std::vector<Vec2> layered_positions(const LayeredBlock& block, int order, Vec2 origin) {
  return Placer(block, order, origin).place();
}

}  // namespace quadrille::layers
