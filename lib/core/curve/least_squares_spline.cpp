#include "curve/least_squares_spline.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "curve/span.hpp"

namespace quadrille::curve {

namespace {

// No memory is allocated for each point.
using BasisValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_curve_degree + 1, 1>;

// The values at t of the degree + 1 basis functions that are not 0 on span k: The NURBS Book, A2.2.
BasisValues basis_values(const Nurbs& spline, int k, double t) {
  const int p = spline.degree;
  BasisValues values(p + 1);
  std::array<double, max_curve_degree + 1> left{}, right{};
  values[0] = 1;
  for (int j = 1; j <= p; ++j) {
    left[j] = t - spline.knots[k + 1 - j];
    right[j] = spline.knots[k + j] - t;
    double saved = 0;
    for (int r = 0; r < j; ++r) {
      const double part = values[r] / (right[r + 1] + left[j - r]);
      values[r] = saved + right[r + 1] * part;
      saved = left[j - r] * part;
    }
    values[j] = saved;
  }
  return values;
}

// The normal equations of a spline whose poles are unknown, but for those that are fixed.
class NormalEquations {
 public:
  // `unknowns`: number of the unknown of each pole, poles of a periodic spline share them; -1: the pole is fixed.
  NormalEquations(Nurbs& spline, const std::vector<int>& unknowns)
      : spline_(spline),
        unknowns_(unknowns),
        size_(*std::max_element(unknowns.begin(), unknowns.end()) + 1),
        right_(Eigen::MatrixX2d::Zero(size_, 2)) {}

  void add(const std::vector<FitPoint>& points) {
    const int n = spline_.degree + 1;
    for (std::size_t i = 0; i < points.size();) {
      const int k = find_span(spline_, points[i].parameter);
      Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(n, n);
      Eigen::MatrixX2d moments = Eigen::MatrixX2d::Zero(n, 2);
      for (; i < points.size() && find_span(spline_, points[i].parameter) == k; ++i) {
        const BasisValues values = basis_values(spline_, k, points[i].parameter);
        squares.noalias() += points[i].weight * values * values.transpose();
        moments.noalias() += points[i].weight * values * Eigen::RowVector2d(points[i].position.x, points[i].position.y);
      }
      add_span(k - spline_.degree, squares, moments);
    }
  }

  // Sets the unknown poles; returns whether they are determined.
  bool solve() {
    Eigen::SparseMatrix<double> matrix(size_, size_);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
    if (factors.info() != Eigen::Success) return false;
    // Pieces of very different lengths differ as much in their weights, but a zero on the diagonal is rounding.
    if (!(factors.vectorD().minCoeff() > 0)) return false;
    const Eigen::MatrixX2d poles = factors.solve(right_);
    if (!poles.allFinite()) return false;
    for (std::size_t i = 0; i < unknowns_.size(); ++i)
      if (unknowns_[i] >= 0) spline_.poles[i] = {poles(unknowns_[i], 0), poles(unknowns_[i], 1)};
    return true;
  }

 private:
  void add_span(int first, const Eigen::MatrixXd& squares, const Eigen::MatrixX2d& moments) {
    for (int i = 0; i <= spline_.degree; ++i) {
      const int row = unknowns_[first + i];
      if (row < 0) continue;
      right_.row(row) += moments.row(i);
      for (int j = 0; j <= spline_.degree; ++j) {
        const int column = unknowns_[first + j];
        const Vec2 pole = spline_.poles[first + j];
        if (column < 0)
          right_.row(row) -= squares(i, j) * Eigen::RowVector2d(pole.x, pole.y);
        else
          entries_.emplace_back(row, column, squares(i, j));
      }
    }
  }

  Nurbs& spline_;
  const std::vector<int>& unknowns_;
  int size_;
  Eigen::MatrixX2d right_;
  std::vector<Eigen::Triplet<double>> entries_;
};

void set_size(Nurbs& spline, int degree) {
  spline.degree = degree;
  spline.poles.assign(spline.knots.size() - degree - 1, Vec2{});
  spline.weights.assign(spline.poles.size(), 1.0);
}

}  // namespace

std::optional<Nurbs> least_squares_spline(int degree, const std::vector<FitKnot>& knots,
                                          const std::vector<FitPoint>& points, const FitEnds& ends) {
  if (knots.size() < 2 || degree < 4) throw Defect("least_squares_spline: needs two knots and degree 4");
  Nurbs spline;
  spline.knots.assign(degree + 1, knots.front().parameter);
  for (std::size_t i = 1; i + 1 < knots.size(); ++i)
    spline.knots.insert(spline.knots.end(), knots[i].multiplicity, knots[i].parameter);
  spline.knots.insert(spline.knots.end(), degree + 1, knots.back().parameter);
  set_size(spline, degree);

  const std::size_t last = spline.poles.size() - 1;
  const double first_step = knots[1].parameter - knots[0].parameter;
  const double last_step = knots.back().parameter - knots[knots.size() - 2].parameter;
  spline.poles[0] = ends.start;
  spline.poles[1] = ends.start + first_step / degree * ends.start_derivative;
  spline.poles[last - 1] = ends.end - last_step / degree * ends.end_derivative;
  spline.poles[last] = ends.end;
  std::vector<int> unknowns(last + 1, -1);
  for (std::size_t i = 2; i + 2 <= last; ++i) unknowns[i] = static_cast<int>(i) - 2;

  NormalEquations equations(spline, unknowns);
  equations.add(points);
  if (!equations.solve()) return std::nullopt;
  return spline;
}

std::optional<Nurbs> periodic_least_squares_spline(int degree, const std::vector<FitKnot>& knots,
                                                   const std::vector<FitPoint>& points) {
  std::vector<double> turn;  // the knots of one turn, the first one as often as its multiplicity
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) turn.insert(turn.end(), knots[i].multiplicity, knots[i].parameter);
  const int count = static_cast<int>(turn.size());
  if (count <= degree) throw Defect("periodic_least_squares_spline: too few knots");
  const double begin = knots.front().parameter, end = knots.back().parameter;
  // Knot number `degree` is the last one at the beginning: the spline has its knots on both sides of the turn.
  Nurbs spline;
  for (int i = 0; i < count + 2 * degree + 1; ++i) {
    int k = i - degree + knots.front().multiplicity - 1;
    double shift = 0;
    for (; k < 0; k += count) shift -= end - begin;
    for (; k >= count; k -= count) shift += end - begin;
    spline.knots.push_back(turn[k] + shift);
  }
  set_size(spline, degree);
  std::vector<int> unknowns;
  for (int i = 0; i < static_cast<int>(spline.poles.size()); ++i) unknowns.push_back(i % count);

  NormalEquations equations(spline, unknowns);
  equations.add(points);
  if (!equations.solve()) return std::nullopt;
  Nurbs clamped = trimmed(spline, begin, end);
  clamped.poles.back() = clamped.poles.front();
  return clamped;
}

std::optional<SpaceCurve> least_squares_spline(int degree, const std::vector<FitKnot>& knots,
                                               const std::vector<SpaceFitPoint>& points,
                                               const std::optional<SpaceFitEnds>& ends) {
  // Least squares do not mix coordinates: x and y are fitted together, and z.
  const auto fit = [&](auto&& part) {
    std::vector<FitPoint> parts;
    for (const SpaceFitPoint& p : points) parts.push_back({p.parameter, part(p.position)});
    if (!ends) return periodic_least_squares_spline(degree, knots, parts);
    return least_squares_spline(
        degree, knots, parts,
        {parts.front().position, part(ends->start_derivative), parts.back().position, part(ends->end_derivative)});
  };
  const std::optional<Nurbs> xy = fit([](Vec3 a) {
    return Vec2{a.x, a.y};
  }),
                             z = fit([](Vec3 a) {
                               return Vec2{a.z, 0};
                             });
  if (!xy || !z) return std::nullopt;
  SpaceCurve spline{degree, xy->knots, {}, xy->weights};
  for (std::size_t i = 0; i < xy->poles.size(); ++i)
    spline.poles.push_back({xy->poles[i].x, xy->poles[i].y, z->poles[i].x});
  return spline;
}

namespace {

class Fit {
 public:
  Fit(const CurveFunction& curve, double length, double tol) : curve_(curve), length_(length), tol_(tol) {
    for (int i = 0; i <= 8; ++i) s_.push_back(i == 8 ? length : length * i / 8);
    Vec2 unused;
    curve(0, start_);
    curve(length, end_);
    for (const double s : s_) x_.push_back(curve(s, unused));
    tests_.resize(8);
  }

  Nurbs run() {
    Nurbs spline = cubic_spline(s_, x_, start_, end_);
    for (int round = 0; round < 24 && refine(spline); ++round) spline = cubic_spline(s_, x_, start_, end_);
    return spline;
  }

 private:
  /// Positions in an interval, computed once: most curves cost more than their splines.
  struct Tests {
    std::optional<Vec2> middle, first_quarter, last_quarter;
  };

  Vec2 position(double s, std::optional<Vec2>& known) {
    Vec2 unused;
    if (!known) known = curve_(s, unused);
    return *known;
  }

  bool is_close(const Nurbs& spline, double s, std::optional<Vec2>& known) {
    return norm2(point(spline, s) - position(s, known)) <= tol_ * tol_;
  }

  bool refine(const Nurbs& spline) {
    std::vector<double> s{s_.front()};
    std::vector<Vec2> x{x_.front()};
    std::vector<Tests> tests;
    for (size_t i = 0; i + 1 < s_.size(); ++i) {
      const double a = s_[i], b = s_[i + 1], middle = (a + b) / 2;
      Tests& here = tests_[i];
      const bool close = is_close(spline, middle, here.middle) &&
                         is_close(spline, (a + middle) / 2, here.first_quarter) &&
                         is_close(spline, (middle + b) / 2, here.last_quarter);
      if (!close && b - a > 1e-6 * length_) {
        s.push_back(middle), x.push_back(position(middle, here.middle));
        tests.push_back({here.first_quarter, {}, {}}), tests.push_back({here.last_quarter, {}, {}});
      } else {
        tests.push_back(here);
      }
      s.push_back(b), x.push_back(x_[i + 1]);
    }
    const bool refined = s.size() > s_.size();
    s_ = std::move(s), x_ = std::move(x), tests_ = std::move(tests);
    return refined;
  }

  const CurveFunction& curve_;
  double length_, tol_;
  Vec2 start_, end_;
  std::vector<double> s_;
  std::vector<Vec2> x_;
  std::vector<Tests> tests_;  // of the intervals of s_
};

}  // namespace

Nurbs fit_line(const CurveFunction& curve, double length, double tol) { return Fit(curve, length, tol).run(); }

}  // namespace quadrille::curve
