#include "curve/fit_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "curve/arc_length.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {
namespace {

constexpr struct {
  double most_turn = 0.25;  ///< of a cell, radians
  /// The distance of x_+^n / n!, n = 2 or 3, on [-1, 1] from polynomials of degree 7.
  double jump_error_2 = 5e-3, jump_error_3 = 1e-4;
  double least_piece = 0.25;  ///< relative to the distance of jumps
} fit_constants{};

void set_jumps(FitNode& node, Bend before, Bend after) {
  node.curvature_jump = std::abs(after.curvature - before.curvature);
  node.slope_jump = std::abs(after.slope - before.slope);
}

double turn_between(const Nurbs& curve, double t0, double t1) {
  constexpr int steps = 4;
  double turn = 0;
  Vec2 before = tangent(curve, t0);
  for (int i = 1; i <= steps; ++i) {
    const Vec2 after = tangent(curve, i == steps ? t1 : t0 + (t1 - t0) * i / steps, true);
    turn += std::abs(std::atan2(cross(before, after), dot(before, after)));
    before = after;
  }
  return turn;
}

// The parameters at which cells end.
std::vector<double> cell_ends(const Nurbs& curve, const ArcLength& length) {
  std::vector<double> ends{curve.begin()};
  for_each_span(curve, [&](double t0, double t1) {
    const int parts = 1 + static_cast<int>(turn_between(curve, t0, t1) / fit_constants.most_turn);
    const double s0 = length.at(t0), s1 = length.at(t1);
    for (int k = 1; k < parts; ++k) ends.push_back(length.parameter(s0 + (s1 - s0) * k / parts));
    ends.push_back(t1);
  });
  return ends;
}

FitCell cell_between(const Nurbs& curve, const ArcLength& length, double t0, double t1) {
  FitCell cell;
  const auto& rule = gauss_rule<8>();
  const double middle = (t0 + t1) / 2, half = (t1 - t0) / 2;
  for (std::size_t i = 0; i < cell.points.size(); ++i) {
    const double t = middle + half * rule.points[i];
    cell.points[i] = {length.at(t), point(curve, t), half * rule.weights[i] * norm(derivative(curve, t))};
  }
  for (int i = 0; i < FitCell::num_checks; ++i) {
    const double t = t0 + (t1 - t0) * i / FitCell::num_checks;
    cell.checks[i] = {length.at(t), point(curve, t)};
  }
  return cell;
}

// How far away the nearest other node is that has at least half the jump of node i, or the nearer end of the curve.
double isolation(const std::vector<FitNode>& nodes, const std::vector<double>& jumps, std::size_t i) {
  const double s = nodes[i].length;
  double nearest = std::min(s - nodes.front().length, nodes.back().length - s);
  for (std::size_t j = i; j-- > 0 && s - nodes[j].length < nearest;)
    if (2 * jumps[j] >= jumps[i]) nearest = s - nodes[j].length;
  for (std::size_t j = i + 1; j < nodes.size() && nodes[j].length - s < nearest; ++j)
    if (2 * jumps[j] >= jumps[i]) nearest = nodes[j].length - s;
  return nearest;
}

}  // namespace

FitCells fit_cells(const Nurbs& curve) {
  const ArcLength length(curve);
  const std::vector<double> ends = cell_ends(curve, length);
  FitCells result;
  for (const double t : ends) {
    FitNode node{t, length.at(t)};
    const bool is_end = t == ends.front() || t == ends.back();
    const double before = is_end ? ends.back() : t, after = is_end ? ends.front() : t;
    set_jumps(node, bend(curve, before, true), bend(curve, after, false));
    result.nodes.push_back(node);
  }
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    result.cells.push_back(cell_between(curve, length, ends[i], ends[i + 1]));
  return result;
}

std::vector<int> lasting_jumps(const std::vector<FitNode>& nodes, int order, double tolerance) {
  const double error = order == 2 ? fit_constants.jump_error_2 : fit_constants.jump_error_3;
  std::vector<double> jumps;
  for (const FitNode& node : nodes) jumps.push_back(order == 2 ? node.curvature_jump : node.slope_jump);
  std::vector<int> lasting;
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const double reach = fit_constants.least_piece * isolation(nodes, jumps, i);
    if (error * jumps[i] * std::pow(reach, order) > tolerance) lasting.push_back(static_cast<int>(i));
  }
  return lasting;
}

}  // namespace quadrille::curve
