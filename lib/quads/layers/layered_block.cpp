#include "layers/layered_block.hpp"

#include <algorithm>
#include <functional>

#include "base/bracketed_root.hpp"
#include "base/tolerance.hpp"
#include "layers/tied_lines.hpp"
#include "mesh/piecewise_polynomial.hpp"
#include "mesh/transfinite.hpp"
#include "sizing/halved_blocks.hpp"

namespace quadrille::layers {
namespace {

/// A block whose nodes are being placed. Rows run along s, columns along t.
struct BlockNodes {
  const LayeredBlock& block;
  std::array<Vec2, 4> corners;
  /// Of the nodes on each side: s (sides 0, 2) or t (1, 3) of the block's map.
  std::array<std::vector<double>, 4> parameters;
  int order;
  const CadFace& face;

  bool has_lines(int direction) const { return !block.lines[direction].empty(); }
  bool has_wall(int side) const { return block.sides[side].wall != nullptr; }
  int width() const { return static_cast<int>(block.fractions[0].size()); }
  int height() const { return static_cast<int>(block.fractions[1].size()); }
  int number(int i, int j) const { return j * width() + i; }

  /// The block's exact map (mesh/transfinite, sizing/halved_blocks).
  Vec2 position(double s, double t) const {
    const std::array<SideTable, 4>& sides = block.tables;
    const std::array<Vec2, 4> on_sides{sides[0].at(s), sides[1].at(t), sides[2].at(s), sides[3].at(t)};
    return block.halved ? sizing::blend_of_whole(on_sides, corners, {s, t}, *block.halved)
                        : mesh::blend_sides(on_sides, corners, s, t);
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
    const std::vector<double>&f3 = parameters[3], &f1 = parameters[1];
    return f3[j] + s * (f1[j] - f3[j]);
  }
};

void place_crossings(const BlockNodes& nodes, std::vector<Vec2>& positions) {
  const std::array<std::vector<double>, 4>& f = nodes.parameters;
  for (int j = 1; j + 1 < nodes.height(); ++j)
    for (int i = 1; i + 1 < nodes.width(); ++i) {
      const Vec2 st = mesh::crossing_parameters(f[0][i], f[1][j], f[2][i], f[3][j]);
      positions[nodes.number(i, j)] = nodes.position(st.x, st.y);
    }
}

LineFamily column_family(const BlockNodes& nodes) {
  const LayeredBlock& block = nodes.block;
  return {block.sides[0], block.sides[2], nodes.lengths(3), nodes.lengths(1), nodes.order};
}

LineFamily row_family(const BlockNodes& nodes) {
  const LayeredBlock& block = nodes.block;
  return {block.sides[3], block.sides[1], nodes.lengths(0), nodes.lengths(2), nodes.order};
}

/// Parameters of the nodes of a line. Where the lengths of its intervals are not given, the arcs beside it have them.
std::vector<double> divided_line(const BlockNodes& nodes, int direction, const LineFamily& family,
                                 const NormalLine& line, int number) {
  const auto& lines = nodes.block.lines[direction];
  if (!lines.empty()) return divide_normal_line(family, line, number, nodes.face, lines[number]);
  const std::array<double, 2> blend{nodes.parameters[direction == 0 ? 0 : 3][number],
                                    nodes.parameters[direction == 0 ? 2 : 1][number]};
  return divide_normal_line(family, line, number, nodes.face,
                            measured_line(family, line, number, blend, nodes.face).sizes);
}

/// Of the nodes on the side that divides the whole block: where its map meets them.
std::vector<double> parameters_in_whole(const BlockNodes& nodes) {
  const int side = nodes.block.halved->side;
  const Vec2 direction = nodes.block.halved->line.direction;
  const auto along = [&](double u) {
    return dot(direction, side % 2 == 0 ? nodes.position(u, side == 2 ? 1 : 0) : nodes.position(side == 1 ? 1 : 0, u));
  };
  std::vector<double> parameters = nodes.parameters[side];
  for (std::size_t k = 1; k + 1 < parameters.size(); ++k) {
    const double at = dot(direction, nodes.block.tables[side].at(parameters[k]));
    parameters[k] = bisect([&](double u) { return along(u) - at; }, 0, 1);
  }
  return parameters;
}

BlockNodes block_nodes(const LayeredBlock& block, int order, const CadFace& face) {
  const std::array<SideTable, 4>& sides = block.tables;
  BlockNodes nodes{
      block, {sides[0].at(0), sides[0].at(1), sides[2].at(1), sides[2].at(0)}, block.fractions, order, face};
  if (block.halved) nodes.parameters[block.halved->side] = parameters_in_whole(nodes);
  return nodes;
}

/// Ties the lines of a family to each other, and applies the factors that are given.
void tie_lines(const BlockNodes& nodes, int direction, const LineFamily& family, const std::vector<NormalLine>& lines,
               std::vector<std::vector<double>>& parameters) {
  if (!nodes.has_lines(direction)) return;
  const std::array<std::vector<double>, 4>& sides = nodes.parameters;
  TiedLines tied(family, lines, sides[direction == 0 ? 3 : 0], sides[direction == 0 ? 1 : 2], parameters);
  tied.tie();
  if (!nodes.block.factors[direction].empty()) tied.scale(nodes.block.factors[direction]);
}

/// (s, t) of all nodes of a block, along side 0 fastest; those inside are not filled in.
std::vector<Vec2> side_parameters(const BlockNodes& nodes) {
  const std::array<std::vector<double>, 4>& f = nodes.parameters;
  std::vector<Vec2> st(f[0].size() * f[1].size());
  for (int i = 0; i < nodes.width(); ++i)
    st[nodes.number(i, 0)] = {f[0][i], 0}, st[nodes.number(i, nodes.height() - 1)] = {f[2][i], 1};
  for (int j = 0; j < nodes.height(); ++j)
    st[nodes.number(0, j)] = {0, f[3][j]}, st[nodes.number(nodes.width() - 1, j)] = {1, f[1][j]};
  return st;
}

/// Divides the rows between sides 3 and 1; returns (s, t) of every node.
std::vector<Vec2> place_rows(const BlockNodes& nodes, std::vector<Vec2>& positions) {
  const LineFamily family = row_family(nodes);
  std::vector<NormalLine> rows;
  std::vector<std::vector<double>> row_s(nodes.height());
  for (int j = 0; j < nodes.height(); ++j) {
    rows.emplace_back([&nodes, j](double s) { return nodes.position(s, nodes.row_t(j, s)); });
    if (j == 0 || j + 1 == nodes.height()) continue;
    row_s[j] = divided_line(nodes, 1, family, rows[j], j);
  }
  tie_lines(nodes, 1, family, rows, row_s);
  std::vector<Vec2> st = side_parameters(nodes);
  for (int j = 1; j + 1 < nodes.height(); ++j)
    for (int i = 1; i + 1 < nodes.width(); ++i) {
      st[nodes.number(i, j)] = {row_s[j][i], nodes.row_t(j, row_s[j][i])};
      positions[nodes.number(i, j)] = rows[j](row_s[j][i]);
    }
  return st;
}

/// A column through the given (s, t) of its nodes: s by t.
mesh::PiecewisePolynomial column_through(const BlockNodes& nodes, const std::vector<Vec2>& st, int i) {
  std::vector<double> s, t;
  for (int j = 0; j < nodes.height(); ++j) {
    s.push_back(st[nodes.number(i, j)].x);
    t.push_back(st[nodes.number(i, j)].y);
  }
  return {std::move(t), std::move(s), nodes.order};
}

/// Divides the columns between sides 0 and 2; returns (s, t) of every node. `through`: (s, t) of nodes through which
/// they run; empty: they are straight in (s, t).
std::vector<Vec2> place_columns(const BlockNodes& nodes, const std::vector<Vec2>& through,
                                std::vector<Vec2>& positions) {
  const LineFamily family = column_family(nodes);
  std::vector<std::function<double(double)>> column_s;
  column_s.reserve(nodes.width());
  std::vector<NormalLine> columns;
  std::vector<std::vector<double>> column_t(nodes.width());
  for (int i = 0; i < nodes.width(); ++i) {
    const bool is_side = i == 0 || i + 1 == nodes.width();
    const double s0 = nodes.parameters[0][i], s2 = nodes.parameters[2][i];
    column_s.emplace_back([s0, s2](double t) { return s0 + t * (s2 - s0); });
    if (!is_side && !through.empty()) column_s.back() = column_through(nodes, through, i);
    columns.emplace_back([&nodes, &s = column_s.back()](double t) { return nodes.position(s(t), t); });
    if (is_side) continue;
    column_t[i] = divided_line(nodes, 0, family, columns[i], i);
  }
  tie_lines(nodes, 0, family, columns, column_t);
  std::vector<Vec2> st = side_parameters(nodes);
  for (int i = 1; i + 1 < nodes.width(); ++i)
    for (int j = 1; j + 1 < nodes.height(); ++j) {
      st[nodes.number(i, j)] = {column_s[i](column_t[i][j]), column_t[i][j]};
      positions[nodes.number(i, j)] = columns[i](column_t[i][j]);
    }
  return st;
}

/// Moves the nodes inside along the rows by the block's shifts. `st`: as from place_columns. In layers nodes keep their
/// heights, above them their t, but for what the end of the layers changes.
void shift_columns(const BlockNodes& nodes, const std::vector<Vec2>& st, std::vector<Vec2>& positions) {
  const std::vector<Vec2> shifted = shifted_along_rows(st, nodes.width(), nodes.order, nodes.block.shifts);
  const LineFamily family = column_family(nodes);
  const int low = family.low_node(), high = family.high_node(nodes.height());
  for (int i = 1; i + 1 < nodes.width(); ++i) {
    const mesh::PiecewisePolynomial s = column_through(nodes, shifted, i);
    const NormalLine column = [&](double t) { return nodes.position(s(t), t); };
    std::vector<double> t = divided_line(nodes, 0, family, column, i);
    const double first = shifted[nodes.number(i, low)].y, last = shifted[nodes.number(i, high)].y;
    for (int j = low + 1; j < high; ++j)
      t[j] = t[low] + (shifted[nodes.number(i, j)].y - first) / (last - first) * (t[high] - t[low]);
    for (int j = 1; j + 1 < nodes.height(); ++j) positions[nodes.number(i, j)] = column(t[j]);
  }
}

/// The block with s and t exchanged.
LayeredBlock transposed(const LayeredBlock& block) {
  LayeredBlock result = block;
  std::reverse(result.tables.begin(), result.tables.end());
  std::reverse(result.sides.begin(), result.sides.end());
  std::reverse(result.fractions.begin(), result.fractions.end());
  std::reverse(result.lengths.begin(), result.lengths.end());
  if (result.halved) result.halved->side = 3 - result.halved->side;
  std::swap(result.lines[0], result.lines[1]);
  std::swap(result.factors[0], result.factors[1]);
  return result;
}

enum class Last { columns, rows, either };

/// The lines that have to be placed last: those along the normals of walls, so that they have exactly the heights of
/// its layers, else those with the shortest interval on a side.
Last placed_last(const LayeredBlock& block) {
  const bool has_columns = block.sides[0].wall || block.sides[2].wall;
  const bool has_rows = block.sides[1].wall || block.sides[3].wall;
  if (has_columns || has_rows) return has_columns ? Last::columns : Last::rows;
  const auto least = [&](int side) {
    const std::vector<double>& fractions = block.fractions[side];
    double step = 1;
    for (std::size_t k = 1; k < fractions.size(); ++k) step = std::min(step, fractions[k] - fractions[k - 1]);
    return step * block.lengths[side];
  };
  const double ratio = std::min(least(0), least(2)) / std::min(least(1), least(3)), tol = tolerance::tied;
  return ratio < 1 - tol ? Last::rows : ratio > 1 + tol ? Last::columns : Last::either;
}

/// Positions in the order of `block`'s nodes, given those of the transposed block.
std::vector<Vec2> transposed(const std::vector<Vec2>& positions, const LayeredBlock& block) {
  const std::size_t width = block.fractions[0].size(), height = block.fractions[1].size();
  std::vector<Vec2> result(positions.size());
  for (std::size_t j = 0; j < height; ++j)
    for (std::size_t i = 0; i < width; ++i) result[j * width + i] = positions[i * height + j];
  return result;
}

/// Positions of all nodes, with the columns placed last.
std::vector<Vec2> columns_last(const LayeredBlock& block, int order, const CadFace& face) {
  const BlockNodes nodes = block_nodes(block, order, face);
  const bool has_rows = nodes.has_lines(1) || nodes.has_wall(1) || nodes.has_wall(3);
  const bool has_columns = nodes.has_lines(0) || nodes.has_wall(0) || nodes.has_wall(2);
  std::vector<Vec2> positions(block.fractions[0].size() * block.fractions[1].size());
  std::vector<Vec2> st;
  if (has_rows) st = place_rows(nodes, positions);
  if (has_columns) st = place_columns(nodes, st, positions);
  if (has_columns && !block.shifts.empty()) shift_columns(nodes, st, positions);
  if (!has_rows && !has_columns) place_crossings(nodes, positions);
  return positions;
}

}  // namespace

std::vector<BlockLine> block_lines(const LayeredBlock& block, int direction, int order, const CadFace& face) {
  const BlockNodes nodes = block_nodes(block, order, face);
  const LineFamily family = direction == 0 ? column_family(nodes) : row_family(nodes);
  const int count = direction == 0 ? nodes.width() : nodes.height();
  std::vector<BlockLine> lines(count);
  for (int i = 1; i + 1 < count; ++i) {
    const double low = nodes.parameters[direction == 0 ? 0 : 3][i], high = nodes.parameters[direction == 0 ? 2 : 1][i];
    const NormalLine line = [&](double u) {
      const double across = low + u * (high - low);
      return direction == 0 ? nodes.position(across, u) : nodes.position(u, across);
    };
    lines[i] = measured_line(family, line, i, {low, high}, face);
  }
  return lines;
}

std::vector<Vec2> layered_positions(const LayeredBlock& block, int order, const CadFace& face) {
  const Last last = placed_last(block);
  const auto exchanged = [&] { return transposed(columns_last(transposed(block), order, face), block); };
  if (last == Last::rows) return exchanged();
  std::vector<Vec2> positions = columns_last(block, order, face);
  if (last == Last::columns || block.lines[0].empty() || block.lines[1].empty()) return positions;
  // The mean of both does not depend on the order of the block's sides.
  const std::vector<Vec2> others = exchanged();
  for (std::size_t k = 0; k < positions.size(); ++k) positions[k] = (positions[k] + others[k]) / 2;
  return positions;
}

}  // namespace quadrille::layers
