#include "growth/straighten_lines.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>

#include "layers/index_cubic.hpp"

namespace quadrille::growth {
namespace {

/// A vertex by row and column.
struct Place {
  int row = 0, column = 0;
};

/// The derivative of a residual by the shift of a vertex.
struct Slope {
  Place of;
  double value = 0;
};

class Straightener {
 public:
  Straightener(const VertexRows& block, double limit)
      : block_(block),
        limit_((1 - straighten_constants.margin) * std::log(limit)),
        num_rows_(static_cast<int>(block.rows.size())),
        num_columns_(static_cast<int>(block.rows.front().size())),
        shifts_(num_rows_, std::vector<double>(num_columns_, 0)) {}

  layers::RowShifts minimised() {
    if (num_unknowns() == 0) return shifts_;
    sum_ = assembled();
    for (int step = 0; step < straighten_constants.max_steps; ++step)
      if (!(improve() > straighten_constants.least_change)) break;
    return shifts_;
  }

 private:
  int free_columns() const { return std::max(0, num_columns_ - block_.fixed_first - block_.fixed_last); }
  int num_unknowns() const { return std::max(0, num_rows_ - 2) * free_columns(); }
  bool is_free(Place p) const {
    return p.row > 0 && p.row + 1 < num_rows_ && p.column >= block_.fixed_first &&
           p.column + block_.fixed_last < num_columns_;
  }
  int unknown(Place p) const { return (p.row - 1) * free_columns() + p.column - block_.fixed_first; }

  /// One Gauss-Newton step, shortened until it reduces the sum; returns the greatest change of a shift, 0 if it does
  /// not.
  double improve() {
    Eigen::SparseMatrix<double> matrix(num_unknowns(), num_unknowns());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::VectorXd change = -solver.solve(gradient_);
    const layers::RowShifts before = shifts_;
    for (double part = 1; part >= straighten_constants.least_part; part /= 2) {
      move(before, change, part);
      const double sum = is_rising() ? assembled() : sum_;
      if (!(sum < sum_)) continue;
      sum_ = sum;
      return part * change.lpNorm<Eigen::Infinity>();
    }
    shifts_ = before;
    return 0;
  }

  void move(const layers::RowShifts& from, const Eigen::VectorXd& change, double part) {
    for (int row = 0; row < num_rows_; ++row)
      for (int column = 0; column < num_columns_; ++column)
        if (is_free({row, column})) shifts_[row][column] = from[row][column] + part * change[unknown({row, column})];
  }

  /// Whether vertices follow each other along all rows.
  bool is_rising() const {
    for (const std::vector<double>& row : shifts_)
      for (std::size_t i = 1; i < row.size(); ++i)
        if (!(1 + row[i] - row[i - 1] >= straighten_constants.least_interval)) return false;
    return true;
  }

  /// The sum of squares of the present shifts; fills in its normal equations.
  double assembled() {
    place();
    entries_.clear();
    gradient_ = Eigen::VectorXd::Zero(num_unknowns());
    double sum = 0;
    for (int row = 0; row + 1 < num_rows_; ++row)
      for (int column = 1; column + 1 < num_columns_; ++column) sum += add_angle({row, column});
    for (int row = 1; row + 1 < num_rows_; ++row) {
      for (const int column : {0, num_columns_ - 2}) sum += add_end({row, column});
      for (int column = 1; column + 1 < num_columns_; ++column) {
        sum += add_growth({{{row, column - 1}, {row, column}, {row, column + 1}}}, true);
        sum += add_growth({{{row - 1, column}, {row, column}, {row + 1, column}}}, false);
      }
    }
    return sum;
  }

  /// Positions and tangents of all vertices on their rows.
  void place() {
    placed_.resize(num_rows_);
    for (int row = 0; row < num_rows_; ++row) {
      placed_[row].clear();
      for (int column = 0; column < num_columns_; ++column)
        placed_[row].push_back(layers::index_cubic(block_.rows[row], column + shifts_[row][column]));
    }
  }

  /// Adds a squared residual, which it returns, to the normal equations.
  template <std::size_t N>
  double add(double residual, const std::array<Slope, N>& slopes) {
    for (const Slope& p : slopes) {
      if (!is_free(p.of)) continue;
      gradient_[unknown(p.of)] += p.value * residual;
      for (const Slope& q : slopes)
        if (is_free(q.of)) entries_.emplace_back(unknown(p.of), unknown(q.of), p.value * q.value);
    }
    return residual * residual;
  }

  /// The edge of a line from `low` to the next row. Its angle is that with the mean direction of both rows, which turns
  /// as the vertices move along bent rows.
  double add_angle(Place low) {
    const Place high{low.row + 1, low.column};
    const Vec2 step = at(high).value - at(low).value;
    const Vec2 along = normalized(normalized(at(low).slope) + normalized(at(high).slope));
    const double across = cross(along, step), side = across < 0 ? -1 : 1;
    const double height = std::max(std::abs(across), straighten_constants.flat * norm(step));
    const double cotangent = dot(along, step) / height;
    const auto slope = [&](Place p, double sign) {
      const Vec2 moves = sign * at(p).slope;
      const double turns = cross(at(p).slope, at(p).bend) / (2 * norm2(at(p).slope));
      return (dot(along, moves) - cotangent * side * cross(along, moves)) / height +
             side * turns * (1 + cotangent * cotangent);
    };
    const auto slopes = [&](double factor) {
      return std::array<Slope, 2>{{{low, factor * slope(low, -1)}, {high, factor * slope(high, 1)}}};
    };
    const double fourth = cotangent / straighten_constants.oblique;
    return add(cotangent, slopes(1)) + add(fourth * cotangent, slopes(2 * fourth));
  }

  /// The first or last interval of a row: the interval beyond it, in the next block, does not change.
  double add_end(Place from) {
    const Place to{from.row, from.column + 1};
    const Vec2 edge = at(to).value - at(from).value, by_length = edge / norm2(edge);
    const double weight = std::sqrt(straighten_constants.smoothness);
    const double change = std::log(norm(edge) / distance(was(from), was(to)));
    return add(weight * change, std::array<Slope, 2>{{{from, -weight * dot(by_length, at(from).slope)},
                                                      {to, weight * dot(by_length, at(to).slope)}}});
  }

  /// Three vertices that follow each other on a row or a line.
  double add_growth(const std::array<Place, 3>& p, bool is_row) {
    const Vec2 before = at(p[1]).value - at(p[0]).value, after = at(p[2]).value - at(p[1]).value;
    const double ratio = std::log(norm(after) / norm(before));
    const double ratio_was = std::log(distance(was(p[1]), was(p[2])) / distance(was(p[0]), was(p[1])));
    const Vec2 a = before / norm2(before), b = after / norm2(after);
    const auto slopes = [&](double weight) {
      return std::array<Slope, 3>{{{p[0], weight * dot(a, at(p[0]).slope)},
                                   {p[1], -weight * dot(a + b, at(p[1]).slope)},
                                   {p[2], weight * dot(b, at(p[2]).slope)}}};
    };
    double sum = 0;
    if (is_row) {
      const double weight = std::sqrt(straighten_constants.smoothness);
      sum += add(weight * (ratio - ratio_was), slopes(weight));
    }
    const double excess = std::abs(ratio) - (is_row ? limit_ : std::max(limit_, std::abs(ratio_was)));
    const double weight = std::sqrt(straighten_constants.excess_weight);
    if (excess > 0) sum += add(weight * std::copysign(excess, ratio), slopes(weight));
    return sum;
  }

  const layers::IndexCubic<Vec2>& at(Place p) const { return placed_[p.row][p.column]; }
  Vec2 was(Place p) const { return block_.rows[p.row][p.column]; }

  const VertexRows& block_;
  double limit_;
  int num_rows_, num_columns_;
  layers::RowShifts shifts_;
  double sum_ = 0;
  std::vector<std::vector<layers::IndexCubic<Vec2>>> placed_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd gradient_;
};

}  // namespace

layers::RowShifts straightening_shifts(const VertexRows& block, double limit) {
  return Straightener(block, limit).minimised();
}

}  // namespace quadrille::growth
