#include "growth/straighten_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "growth/line_intervals.hpp"
#include "growth/normal_equations.hpp"
#include "mesh/mesh_score.hpp"

namespace quadrille::growth {
namespace {

struct StraightenConstants {
  double oblique = 0.5;         ///< cotangent at which both powers are equal
  double smoothness = 50;       ///< weight of changes of the growth along rows
  double excess_weight = 300;   ///< of edges that grow faster than the limit
  double margin = 0.1;          ///< part of the limit's logarithm that is left for what follows
  double least_interval = 0.1;  ///< part of its interval that is left of one
  double flat = 1e-3;           ///< sine of the least angle that is told from 0
  int max_steps = 12;           ///< Gauss-Newton steps
  double least_change = 1e-3;   ///< of a shift, in intervals, in a step that is not the last
  double least_part = 1e-3;     ///< of a step, which is halved until it reduces the sum
};
constexpr StraightenConstants straighten_constants;

/// A vertex by row and column.
struct Place {
  int row = 0, column = 0;
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
  /// The number of the vertex's shift; -1: it is fixed.
  int unknown(Place p) const {
    const bool is_free = p.row > 0 && p.row + 1 < num_rows_ && p.column >= block_.fixed_first &&
                         p.column + block_.fixed_last < num_columns_;
    return is_free ? (p.row - 1) * free_columns() + p.column - block_.fixed_first : -1;
  }

  /// One Gauss-Newton step, shortened until it reduces the sum; returns the greatest change of a shift, 0 if it does
  /// not.
  double improve() {
    const Eigen::VectorXd change = equations_.step();
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
        if (const int k = unknown({row, column}); k >= 0) shifts_[row][column] = from[row][column] + part * change[k];
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
    equations_ = NormalEquations(num_unknowns());
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
    const double by_low = slope(low, -1), by_high = slope(high, 1), factor = cotangent / straighten_constants.oblique;
    return equations_.add(1, cotangent, {{unknown(low), by_low}, {unknown(high), by_high}}) +
           equations_.add(1, factor * cotangent,
                          {{unknown(low), 2 * factor * by_low}, {unknown(high), 2 * factor * by_high}});
  }

  /// The first or last interval of a row: the interval beyond it, in the next block, does not change.
  double add_end(Place from) {
    const Place to{from.row, from.column + 1};
    const Vec2 edge = at(to).value - at(from).value, by_length = edge / norm2(edge);
    return equations_.add(
        straighten_constants.smoothness, std::log(norm(edge) / distance(was(from), was(to))),
        {{unknown(from), -dot(by_length, at(from).slope)}, {unknown(to), dot(by_length, at(to).slope)}});
  }

  /// Three vertices that follow each other on a row or a line.
  double add_growth(const std::array<Place, 3>& p, bool is_row) {
    const Vec2 before = at(p[1]).value - at(p[0]).value, after = at(p[2]).value - at(p[1]).value;
    const double ratio = std::log(norm(after) / norm(before));
    const double ratio_was = std::log(distance(was(p[1]), was(p[2])) / distance(was(p[0]), was(p[1])));
    const Vec2 a = before / norm2(before), b = after / norm2(after);
    const auto add = [&](double weight, double residual) {
      return equations_.add(weight, residual,
                            {{unknown(p[0]), dot(a, at(p[0]).slope)},
                             {unknown(p[1]), -dot(a + b, at(p[1]).slope)},
                             {unknown(p[2]), dot(b, at(p[2]).slope)}});
    };
    double sum = is_row ? add(straighten_constants.smoothness, ratio - ratio_was) : 0;
    const double excess = std::abs(ratio) - (is_row ? limit_ : std::max(limit_, std::abs(ratio_was)));
    if (excess > 0) sum += add(straighten_constants.excess_weight, std::copysign(excess, ratio));
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
  NormalEquations equations_{0};
};

/// The lines along the normals of the walls cross the rows: columns, if side 0 or 2 is a wall.
VertexRows vertex_rows(const layers::WallPlan& walls, int block, const BlockVertices& vertices, int order) {
  const std::array<int, 4>& sides = walls.walls.of_block[block];
  const int along = sides[0] >= 0 || sides[2] >= 0 ? 1 : 0;  // the direction of the rows
  const int num_rows = along == 1 ? vertices.rows() : vertices.columns();
  const int num_lines = along == 1 ? vertices.columns() : vertices.rows();
  const auto [first, last] = walls.num_fixed_along(block, along);
  VertexRows result{{}, 1 + first, 1 + last};
  for (int row = 0; row <= num_rows; ++row) {
    result.rows.emplace_back();
    for (int line = 0; line <= num_lines; ++line) result.rows.back().push_back(vertices.at(along, row * order, line));
  }
  return result;
}

}  // namespace

layers::RowShifts straightening_shifts(const VertexRows& block, double limit) {
  return Straightener(block, limit).minimised();
}

std::vector<layers::RowShifts> block_shifts(const BlockLayout& blocks, const layers::WallPlan& walls,
                                            const sizing::ArcDivisions& divisions, const QuadMesh& mesh, double limit) {
  const std::vector<double> skewness = mesh::block_skewness(mesh);
  const std::vector<BlockVertices> vertices = block_vertices(blocks, divisions, mesh);
  std::vector<layers::RowShifts> shifts(blocks.num_blocks());
  bool any = false;
  for (int block = 0; block < blocks.num_blocks(); ++block) {
    if (!walls.has_wall(block) || skewness[block] == 0) continue;
    shifts[block] = straightening_shifts(vertex_rows(walls, block, vertices[block], mesh.order), limit);
    any = true;
  }
  return any ? shifts : std::vector<layers::RowShifts>();
}

bool drop_useless(const QuadMesh& before, const QuadMesh& straight, std::vector<layers::RowShifts>& shifts) {
  const std::vector<double> was = mesh::block_skewness(before), now = mesh::block_skewness(straight);
  bool any = false;
  for (std::size_t block = 0; block < shifts.size(); ++block) {
    if (shifts[block].empty() || mesh::exceeds(was[block], now[block])) continue;
    shifts[block].clear();
    any = true;
  }
  return any;
}

}  // namespace quadrille::growth
