#include "spectral/modified_basis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

// A function's value and its derivatives with respect to xi1 and xi2.
struct Jet {
  double f = 0, d1 = 0, d2 = 0;
};

Jet operator+(Jet a, Jet b) { return {a.f + b.f, a.d1 + b.d1, a.d2 + b.d2}; }
Jet operator-(Jet a, Jet b) { return {a.f - b.f, a.d1 - b.d1, a.d2 - b.d2}; }
Jet operator*(double s, Jet a) { return {s * a.f, s * a.d1, s * a.d2}; }
Jet operator*(Jet a, Jet b) { return {a.f * b.f, a.d1 * b.f + a.f * b.d1, a.d2 * b.f + a.f * b.d2}; }

// q_0..q_n at (x, t), which are jets or numbers.
template <class Number>
std::vector<Number> scaled_jacobi(int n, Number x, Number t, Number one) {
  std::vector<Number> q(n + 1, one);
  const Number t2 = t * t;
  for (int k = 0; k < n; ++k) {
    const JacobiStep step = jacobi_step(k, 1, 1);
    q[k + 1] = step.a * (x * q[k]);
    if (k > 0) q[k + 1] = q[k + 1] - step.c * (t2 * q[k - 1]);
  }
  return q;
}

// The modes of degree 2..P: product * q(x, t).
template <class Number>
void append_edge(int order, Number product, Number x, Number t, Number one, std::vector<Number>& modes) {
  if (order < 2) return;
  const std::vector<Number> q = scaled_jacobi(order - 2, x, t, one);
  for (int d = 2; d <= order; ++d) modes.push_back(edge_mode_scale(d) * (product * q[d - 2]));
}

// P_0..P_n^(2i+3,1)(2 l - 1).
std::vector<Jet> upward_jacobi(int n, int i, Jet l) {
  std::vector<Jet> values(n + 1, Jet{1, 0, 0});
  const Jet x = 2.0 * l - Jet{1, 0, 0};
  for (int k = 0; k < n; ++k) {
    const JacobiStep step = jacobi_step(k, 2 * i + 3, 1);
    values[k + 1] = (step.a * x + Jet{step.b, 0, 0}) * values[k];
    if (k > 0) values[k + 1] = values[k + 1] - step.c * values[k - 1];
  }
  return values;
}

void append_interior(int order, const std::array<Jet, 3>& l, std::vector<Jet>& modes) {
  if (order < 3) return;
  const int top = order - 3;
  const Jet one{1, 0, 0}, bubble = l[0] * l[1] * l[2];
  const std::vector<Jet> across = scaled_jacobi(top, l[1] - l[0], l[0] + l[1], one);
  std::vector<std::vector<Jet>> upward;
  for (int i = 0; i <= top; ++i) upward.push_back(upward_jacobi(top - i, i, l[2]));
  for (int degree = 0; degree <= top; ++degree) {
    for (int i = 0; i <= degree; ++i) modes.push_back(bubble * across[i] * upward[i][degree - i]);
  }
}

std::vector<Jet> modified_jets(int order, Vec2 xi) {
  const std::array<Jet, 3> l{Jet{-(xi.x + xi.y) / 2, -0.5, -0.5}, Jet{(1 + xi.x) / 2, 0.5, 0},
                             Jet{(1 + xi.y) / 2, 0, 0.5}};
  std::vector<Jet> modes(l.begin(), l.end());
  modes.reserve(num_tri_modes(order));
  const Jet one{1, 0, 0}, upward = 2.0 * l[2] - one;
  append_edge(order, l[0] * l[1], l[1] - l[0], l[0] + l[1], one, modes);
  append_edge(order, l[1] * l[2], upward, one, one, modes);
  append_edge(order, l[2] * l[0], -1.0 * upward, one, one, modes);
  append_interior(order, l, modes);
  return modes;
}

std::vector<int> make_subset(int order, int higher_order) {
  std::vector<int> modes{0, 1, 2};
  for (int edge = 0; edge < 3; ++edge) {
    for (int d = 2; d <= order; ++d) modes.push_back(edge_mode(higher_order, edge, d));
  }
  for (int i = 0; i < num_interior_modes(order); ++i) modes.push_back(num_boundary_modes(higher_order) + i);
  return modes;
}

}  // namespace

void modified_gradients(int order, Vec2 xi, double* values, double* d_xi1, double* d_xi2) {
  for (const Jet& mode : modified_jets(order, xi)) {
    *values++ = mode.f;
    *d_xi1++ = mode.d1;
    *d_xi2++ = mode.d2;
  }
}

const std::vector<int>& modified_subset(int order, int higher_order) {
  static PerOrder<std::vector<int>> tables([](int key) { return make_subset(key / 100, key % 100); });
  return tables[100 * order + higher_order];
}

void edge_mode_values(int order, double s, double* values) {
  std::vector<double> modes;
  append_edge(order, (1 - s) * (1 + s) / 4, s, 1.0, 1.0, modes);
  std::copy(modes.begin(), modes.end(), values);
}

namespace {

using Values = Eigen::ArrayXd;  // at the points of one rule

// A function of one variable at the points of a rule: its values and derivatives.
struct Sampled {
  Values f, df;
};

Sampled operator*(const Sampled& a, const Sampled& b) { return {a.f * b.f, a.df * b.f + a.f * b.df}; }
Sampled operator*(double s, const Sampled& a) { return {s * a.f, s * a.df}; }

// a + b x at the points x.
Sampled linear(double a, double b, const Values& x) { return {a + b * x, Values::Constant(x.size(), b)}; }

// P_0..P_n^(alpha, beta) of `sign` * x at the points x.
std::vector<Sampled> jacobi_polynomials(int n, double alpha, double beta, const Values& x, double sign = 1) {
  std::vector<Sampled> p{linear(1, 0, x)};
  for (int k = 0; k < n; ++k) {
    const JacobiStep step = jacobi_step(k, alpha, beta);
    p.push_back(linear(step.b, sign * step.a, x) * p.back());
    if (k > 0) p.back().f -= step.c * p[k - 1].f, p.back().df -= step.c * p[k - 1].df;
  }
  return p;
}

// Appends columns in pairs of values and derivatives.
struct Columns {
  Eigen::MatrixXd& f;
  Eigen::MatrixXd& df;
  int next = 0;

  void append(const Sampled& column) {
    f.col(next) = column.f;
    df.col(next++) = column.df;
  }
};

void append_factors(int order, const Values& x, Columns columns) {
  columns.append(linear(1, 0, x));
  columns.append(linear(0.5, -0.5, x));
  columns.append(linear(0.5, 0.5, x));
  const Sampled bubble = linear(0.5, -0.5, x) * linear(0.5, 0.5, x);
  const std::vector<Sampled> jacobi = jacobi_polynomials(order - 2, 1, 1, x);
  for (int i = 0; i <= order - 2; ++i) columns.append(bubble * jacobi[i]);
}

// Appends the modes of one factor after another, and their positions.
class ModeColumns {
 public:
  ModeColumns(int order, const Values& y, FactoredModes& modes)
      : order_(order), y_(y), columns_{modes.g, modes.dg}, modes_(modes) {}

  void append_all() {
    const Sampled t = linear(0.5, -0.5, y_), up = linear(0.5, 0.5, y_);
    start_factor();
    append(2, up);
    append_vertex_and_edge(0, 2, t, up, -1);
    append_vertex_and_edge(1, 1, t, up, 1);
    Sampled power = t * t;
    for (int i = 0; i <= order_ - 2; ++i, power = power * t) {
      start_factor();
      append(edge_mode(order_, 0, i + 2), edge_mode_scale(i + 2) * power);
      append_interior(i, power * up);
    }
    start_factor();
  }

 private:
  void start_factor() { modes_.first.push_back(columns_.next); }

  void append(int position, const Sampled& values) {
    columns_.append(values);
    modes_.position.push_back(position);
  }

  void append_vertex_and_edge(int vertex, int edge, const Sampled& t, const Sampled& up, double sign) {
    start_factor();
    append(vertex, t);
    const std::vector<Sampled> jacobi = jacobi_polynomials(order_ - 2, 1, 1, y_, sign);
    for (int d = 2; d <= order_; ++d) append(edge_mode(order_, edge, d), edge_mode_scale(d) * (t * up * jacobi[d - 2]));
  }

  void append_interior(int i, const Sampled& bubble) {
    const int top = order_ - 3 - i;
    if (top < 0) return;
    const std::vector<Sampled> jacobi = jacobi_polynomials(top, 2 * i + 3, 1, y_);
    for (int j = 0; j <= top; ++j) append(interior_mode(order_, i, j), bubble * jacobi[j]);
  }

  int order_;
  const Values& y_;
  Columns columns_;
  FactoredModes& modes_;
};

Values points_of(const Quadrature& rule) {
  return Eigen::Map<const Values>(rule.points.data(), static_cast<Eigen::Index>(rule.points.size()));
}

// Points eta2 x degrees q = 0..order - p: the factor of eta2 of the orthogonal modes (p, q), times the weight.
Eigen::MatrixXd weighted_orthogonal_factors(int order, int p, const Quadrature& eta2) {
  const int num_points = static_cast<int>(eta2.points.size());
  Eigen::MatrixXd values(num_points, order - p + 1);
  const JacobiPolynomials polynomials(order - p, 2 * p + 1, 0);
  for (int j = 0; j < num_points; ++j) {
    const std::vector<double> jacobi = polynomials.all(eta2.points[j]);
    const double t = std::pow((1 - eta2.points[j]) / 2, p) * eta2.weights[j] / 2;
    for (int q = 0; q <= order - p; ++q) values(j, q) = t * orthogonal_scale(p, q) * jacobi[q];
  }
  return values;
}

// The integral of f_c P_p is zero but for p up to the degree of f_c, and for f_{3+i}, which is (1 - eta1^2) P_i^(1,1),
// but for p = i and i + 2. The products in eta2 have degree 2 P, for which P + 1 points are exact.
Eigen::MatrixXd make_to_orthogonal(int order) {
  const FactoredModes modes = factored_modes(order, order + 1);
  Eigen::MatrixXd table = Eigen::MatrixXd::Zero(num_tri_modes(order), num_tri_modes(order));
  for (int p = 0; p <= order; ++p) {
    const Eigen::MatrixXd orthogonal = weighted_orthogonal_factors(order, p, modes.eta2);
    const JacobiPolynomials legendre(p, 0, 0);
    std::vector<double> values;
    for (const double x : modes.eta1.points) values.push_back(legendre.last(x));
    for (int c = 0; c < modes.num_factors(); ++c) {
      const int degree = c < 3 ? (c + 1) / 2 : c - 1;
      if (p > degree || (c >= 3 && p != degree && p != degree - 2)) continue;
      double integral = 0;
      for (std::size_t i = 0; i < modes.eta1.points.size(); ++i)
        integral += modes.eta1.weights[i] * modes.f(i, c) * values[i];
      const Eigen::MatrixXd block =
          integral * modes.g.middleCols(modes.first[c], modes.num_modes(c)).transpose() * orthogonal;
      for (int row = 0; row < block.rows(); ++row)
        for (int q = 0; q < block.cols(); ++q)
          table(modes.position[modes.first[c] + row], (p + q) * (p + q + 1) / 2 + p) = block(row, q);
    }
  }
  return table;
}

}  // namespace

FactoredModes factored_modes(int order, int num_points) {
  FactoredModes modes;
  modes.eta1 = gauss_legendre(num_points);
  modes.eta2 = gauss_jacobi(num_points, 1, 0);
  modes.f.resize(num_points, order + 2);
  modes.df.resize(num_points, order + 2);
  modes.g.resize(num_points, num_tri_modes(order));
  modes.dg.resize(num_points, num_tri_modes(order));
  append_factors(order, points_of(modes.eta1), {modes.f, modes.df});
  const Values y = points_of(modes.eta2);
  ModeColumns(order, y, modes).append_all();
  return modes;
}

const Eigen::MatrixXd& modified_to_orthogonal(int order) {
  static PerOrder<Eigen::MatrixXd> tables([](int n) {
    static PerOrder<Eigen::MatrixXd> large(make_to_orthogonal);
    const int higher = table_order(n);
    return Eigen::MatrixXd(large[higher](modified_subset(n, higher), Eigen::seqN(0, num_tri_modes(n))));
  });
  return tables[order];
}

}  // namespace quadrille::spectral
