#include "curve/simplify_spline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/tolerance.hpp"
#include "curve/chain.hpp"
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

namespace {

/// A degree that needs few pieces at tolerances of 1e-6 to 1e-9; least squares keep ten digits.
constexpr int fit_degree = 7;
constexpr int least_breaks = 32;
/// C1 where the curvature jumps, C2 where its derivative does.
constexpr int curvature_multiplicity = fit_degree - 1, slope_multiplicity = fit_degree - 2;
constexpr int max_rounds = 40;
constexpr int periodic_pieces = 8;

bool closes_smoothly(const Nurbs& curve) {
  if (!(distance(curve.poles.front(), curve.poles.back()) <= 1e-12 * polygon_length(curve))) return false;
  const Vec2 a = tangent(curve, curve.end(), true), b = tangent(curve, curve.begin());
  return std::abs(std::atan2(cross(a, b), dot(a, b))) <= tolerance::round_off;
}

int num_inner_knots(const Nurbs& curve) {
  int count = 0;
  for (std::size_t i = 1; i < curve.knots.size(); ++i) count += curve.knots[i - 1] < curve.knots[i];
  return count - 1;
}

/// Finds the knots of the fit among the nodes of the curve.
class Simplifier {
 public:
  Simplifier(const Nurbs& curve, double tolerance, bool is_periodic)
      : curve_(curve),
        tolerance_(tolerance),
        is_periodic_(is_periodic),
        cells_(fit_cells(curve)),
        multiplicities_(cells_.nodes.size(), 0) {
    for (const int i : lasting_jumps(cells_.nodes, 3, tolerance)) multiplicities_[i] = slope_multiplicity;
    for (const int i : lasting_jumps(cells_.nodes, 2, tolerance)) multiplicities_[i] = curvature_multiplicity;
    multiplicities_.front() = multiplicities_.back() = 1;
    for (const FitCell& cell : cells_.cells) points_.insert(points_.end(), cell.points.begin(), cell.points.end());
  }

  std::optional<SimplifiedSpline> run() {
    SimplifiedSpline result;
    result.knots_before = num_inner_knots(curve_);
    if (is_periodic_)
      while (num_knots() <= periodic_pieces && bisect(pieces())) continue;
    for (int round = 0; round < max_rounds && num_knots() - 2 <= result.knots_before / 2; ++round) {
      std::optional<Nurbs> fit = fitted();
      if (!fit) return std::nullopt;
      result.curve = std::move(*fit);
      const std::vector<Piece> missed = missed_pieces(result);
      if (missed.empty()) {
        result.knots_after = num_inner_knots(result.curve);
        return result;
      }
      if (!refine(missed)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  /// Between two nodes that are knots.
  struct Piece {
    int first, last;
    int num_cells() const { return last - first; }
  };

  std::vector<Piece> pieces() const {
    std::vector<Piece> result;
    for (int first = 0, i = 1; i < static_cast<int>(multiplicities_.size()); ++i)
      if (multiplicities_[i] > 0) result.push_back({first, i}), first = i;
    return result;
  }

  int num_knots() const {
    return static_cast<int>(std::count_if(multiplicities_.begin(), multiplicities_.end(), [](int m) { return m > 0; }));
  }

  std::optional<Nurbs> fitted() const {
    std::vector<FitKnot> knots;
    for (std::size_t i = 0; i < multiplicities_.size(); ++i)
      if (multiplicities_[i] > 0) knots.push_back({cells_.nodes[i].length, multiplicities_[i]});
    if (is_periodic_) {
      if (num_knots() <= fit_degree + 1) return std::nullopt;
      return periodic_least_squares_spline(fit_degree, knots, points_);
    }
    const FitEnds ends{curve_.poles.front(), tangent(curve_, curve_.begin()), curve_.poles.back(),
                       tangent(curve_, curve_.end(), true)};
    return least_squares_spline(fit_degree, knots, points_, ends);
  }

  double greatest_distance(const Nurbs& fit, const Piece& piece) const {
    // In the short cells of a long piece, the difference varies little.
    const int step = piece.num_cells() >= 4 ? 4 : 1;
    double greatest = 0;
    for (int c = piece.first; c < piece.last; ++c)
      for (int i = 0; i < FitCell::num_checks; i += step) {
        const FitPoint& check = cells_.cells[c].checks[i];
        greatest = std::max(greatest, distance(point(fit, check.parameter), check.position));
      }
    return greatest;
  }

  std::vector<Piece> missed_pieces(SimplifiedSpline& result) const {
    std::vector<Piece> missed;
    result.distance = 0;
    for (const Piece& piece : pieces()) {
      const double distance = greatest_distance(result.curve, piece);
      result.distance = std::max(result.distance, distance);
      if (!(distance <= tolerance_)) missed.push_back(piece);
    }
    return missed;
  }

  /// Makes the node nearest to the middle of each piece a knot, or both of two that are equally near. Returns whether
  /// there was one.
  bool bisect(const std::vector<Piece>& pieces) {
    bool is_changed = false;
    for (const Piece& piece : pieces) {
      if (piece.num_cells() < 2) continue;
      const auto s = [&](int i) { return cells_.nodes[i].length; };
      const double middle = (s(piece.first) + s(piece.last)) / 2;
      int after = piece.first + 1;
      while (after + 1 < piece.last && s(after) < middle) ++after;
      const int before = std::max(after - 1, piece.first + 1);
      const double lead = (middle - s(before)) - (s(after) - middle), same = tolerance::tied * (s(after) - s(before));
      if (lead <= same) multiplicities_[before] = std::max(multiplicities_[before], 1);
      if (lead >= -same) multiplicities_[after] = std::max(multiplicities_[after], 1);
      is_changed = true;
    }
    return is_changed;
  }

  /// Bisects pieces of several cells. At the ends of the others one derivative less is continuous.
  bool refine(const std::vector<Piece>& missed) {
    bool is_changed = bisect(missed);
    std::vector<bool> is_raised(multiplicities_.size(), false);
    for (const Piece& piece : missed) {
      if (piece.num_cells() > 1) continue;
      for (const int i : {piece.first, piece.last}) {
        const bool is_end = i == 0 || i + 1 == static_cast<int>(multiplicities_.size());
        if (is_end || is_raised[i] || multiplicities_[i] >= curvature_multiplicity) continue;
        ++multiplicities_[i];
        is_raised[i] = is_changed = true;
      }
    }
    return is_changed;
  }

  const Nurbs& curve_;
  double tolerance_;
  bool is_periodic_;
  FitCells cells_;
  std::vector<int> multiplicities_;  ///< of the nodes as knots of the fit; 0: the node is none
  std::vector<FitPoint> points_;
};

}  // namespace

std::optional<SimplifiedSpline> simplified_spline(const Nurbs& curve, double tolerance) {
  const std::size_t num_breaks = smoothness_breaks(curve).size();
  if (num_breaks < least_breaks) return std::nullopt;
  std::optional<SimplifiedSpline> result;
  if (closes_smoothly(curve)) result = Simplifier(curve, tolerance, true).run();
  if (!result) result = Simplifier(curve, tolerance, false).run();  // the curvature may jump at the seam
  if (result && 2 * smoothness_breaks(result->curve).size() > num_breaks) return std::nullopt;
  return result;
}

}  // namespace quadrille::curve
