#include "spectral/quad_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "spectral/bernstein_tables.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quad_samples.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

constexpr double sharp = 1e-10;       ///< difference of a bound from the least value, of this
constexpr double bilinear_ulps = 16;  ///< by which nodes of bilinear elements are rounded at most

/// Coefficients of one derivative of one coordinate, scaled by the binomials of its degrees.
struct Derivative {
  int rows = 0, columns = 0;   ///< j along xi2, i along xi1
  std::vector<double> scaled;  ///< coefficient times both binomials
  double largest = 0, error = 0;
};

/// `along1` (columns x (N+1)) acts along xi1, `along2` (rows x (N+1)) along xi2.
Derivative apply(int n, const Rows& along1, const Rows& along2, const Rows& nodal, const std::vector<double>& binomial1,
                 const std::vector<double>& binomial2) {
  const int width = n + 1;
  Derivative d;
  d.columns = static_cast<int>(along1.size()) / width;
  d.rows = static_cast<int>(along2.size()) / width;
  Rows half(width * d.columns, 0.0L);
  for (int q = 0; q < width; ++q)
    for (int i = 0; i < d.columns; ++i) {
      long double sum = 0;
      for (int p = 0; p < width; ++p) sum += along1[i * width + p] * nodal[q * width + p];
      half[q * d.columns + i] = sum;
    }
  d.scaled.resize(d.rows * d.columns);
  for (int j = 0; j < d.rows; ++j)
    for (int i = 0; i < d.columns; ++i) {
      long double sum = 0;
      for (int q = 0; q < width; ++q) sum += along2[j * width + q] * half[q * d.columns + i];
      const double coef = static_cast<double>(sum);
      d.largest = std::max(d.largest, std::abs(coef));
      d.scaled[j * d.columns + i] = coef * binomial1[i] * binomial2[j];
    }
  return d;
}

/// Error bound: both sums, the entries of both matrices and the shift of the nodes, each a few units in the last place,
/// then the rounding to double.
double conversion_error(int n, const Derivative& d, double largest_node, const BernsteinTables& t) {
  return (12 * n + 32) * extended_roundoff * t.value_norm * t.derivative_norm * largest_node +
         unit_roundoff * d.largest;
}

void add_product(const Derivative& a, const Derivative& b, double sign, BernsteinSquare& det) {
  const int width = det.degree + 1;
  for (int ja = 0; ja < a.rows; ++ja)
    for (int ia = 0; ia < a.columns; ++ia) {
      const double factor = sign * a.scaled[ja * a.columns + ia];
      for (int jb = 0; jb < b.rows; ++jb) {
        double* row = &det.coefs[(ja + jb) * width + ia];
        const double* other = &b.scaled[jb * b.columns];
        for (int ib = 0; ib < b.columns; ++ib) row[ib] += factor * other[ib];
      }
    }
  // Each coefficient is a convex combination of products a_ij b_kl: errors of the factors enter with weight one.
  det.error += a.largest * b.error + b.largest * a.error + a.error * b.error +
               (2 * a.rows * a.columns + 12) * unit_roundoff * a.largest * b.largest;
}

/// Halves along the rows (stride 1 between the coefficients of a line) or columns.
void halve(std::vector<double>& low, std::vector<double>& high, int width, int stride, int line_stride) {
  high = low;
  for (int line = 0; line < width; ++line)
    halve_line(&low[line * line_stride], &high[line * line_stride], width, stride);
}

/// The four quarters of the square; the caller sets their `error`.
std::array<BernsteinSquare, 4> quarters(const BernsteinSquare& whole) {
  const int width = whole.degree + 1;
  std::array<BernsteinSquare, 4> parts;
  for (BernsteinSquare& part : parts) part = {whole.degree, {}, whole.error};
  parts[0].coefs = whole.coefs;
  halve(parts[0].coefs, parts[1].coefs, width, 1, width);
  halve(parts[0].coefs, parts[2].coefs, width, width, 1);
  halve(parts[1].coefs, parts[3].coefs, width, width, 1);
  return parts;
}

/// The least of the coefficients that are values of the polynomial: those at the corners.
double least_corner(const BernsteinSquare& p) {
  const int width = p.degree + 1;
  return std::min({p.coefs.front(), p.coefs[width - 1], p.coefs[width * (width - 1)], p.coefs.back()});
}

/// An element that is bilinear but for rounding, as all are whose sides are straight: its derivatives at the corners
/// are those of its sides, and det J and the scaled Jacobian are least at corners.
struct BilinearElement {
  std::array<Vec2, 2> by_xi1, by_xi2;  ///< at xi2 = -1, 1; at xi1 = -1, 1
  double deviation = 0;                ///< bound of the distance of nodes from it, by coordinate

  Vec2 a(int corner) const { return by_xi1[corner / 2]; }  ///< corners: xi1 fastest
  Vec2 b(int corner) const { return by_xi2[corner % 2]; }
};

std::optional<BilinearElement> as_bilinear(int order, const Vec2* nodes) {
  const std::vector<double>& xi = gll_points(order);
  const int n = order + 1;
  const Vec2 origin = nodes[0], right = nodes[order] - origin, top = nodes[n * order] - origin;
  const Vec2 twist = nodes[n * n - 1] - origin - right - top;
  const auto greatest = [](Vec2 v) { return std::max(std::abs(v.x), std::abs(v.y)); };
  const double size = greatest(right) + greatest(top) + greatest(twist);
  const double limit = bilinear_ulps * unit_roundoff * (greatest(origin) + size);
  double deviation = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double s = (1 + xi[i]) / 2, t = (1 + xi[j]) / 2;
      deviation = std::max(deviation, greatest(nodes[j * n + i] - origin - (s * right + t * top + s * t * twist)));
      if (!(deviation <= limit)) return std::nullopt;
    }
  return BilinearElement{
      {right / 2, (right + twist) / 2}, {top / 2, (top + twist) / 2}, deviation + bilinear_ulps * unit_roundoff * size};
}

/// As conversion_error and add_product bound it: a node is at most `deviation` off. No value if the bound is not sharp.
std::optional<double> bilinear_lower_bound(int order, const BilinearElement& element) {
  const BernsteinTables& t = bernstein_tables(order);
  Vec2 largest_a, largest_b;
  double least = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 4; ++corner) {
    const Vec2 a = element.a(corner), b = element.b(corner);
    least = std::min(least, cross(a, b));
    largest_a = {std::max(largest_a.x, std::abs(a.x)), std::max(largest_a.y, std::abs(a.y))};
    largest_b = {std::max(largest_b.x, std::abs(b.x)), std::max(largest_b.y, std::abs(b.y))};
  }
  const double error = t.value_norm * t.derivative_norm * element.deviation;
  const auto product_error = [&](double a, double b) {
    return (a + b) * error + error * error + bilinear_ulps * unit_roundoff * a * b;
  };
  const double below = product_error(largest_a.x, largest_b.y) + product_error(largest_a.y, largest_b.x);
  if (!(below < sharp * least)) return std::nullopt;
  return least - below;
}

ScaledJacobianMinimum least_at_corners(const BilinearElement& element) {
  ScaledJacobianMinimum least{2, {}};
  for (int corner = 0; corner < 4; ++corner) {
    const Vec2 a = element.a(corner), b = element.b(corner);
    const double scale = std::sqrt(norm2(a) * norm2(b)), value = scale > 0 ? cross(a, b) / scale : 0;
    if (value < least.value) least = {std::min(value, 1.0), {corner % 2 == 0 ? -1.0 : 1.0, corner < 2 ? -1.0 : 1.0}};
  }
  if (least.value <= 0) least.value = -1;
  return least;
}

}  // namespace

BernsteinSquare quad_jacobian_det(int order, const Vec2* nodes) {
  const BernsteinTables& t = bernstein_tables(order);
  const int n = order, count = (n + 1) * (n + 1);
  const Vec2 centre = nodes[(n / 2) * (n + 1) + n / 2];
  Rows x(count), y(count);
  double size_x = 0, size_y = 0;
  for (int k = 0; k < count; ++k) {
    x[k] = static_cast<long double>(nodes[k].x) - centre.x;
    y[k] = static_cast<long double>(nodes[k].y) - centre.y;
    size_x = std::max(size_x, std::abs(static_cast<double>(x[k])));
    size_y = std::max(size_y, std::abs(static_cast<double>(y[k])));
  }
  const auto by_xi1 = [&](const Rows& c) { return apply(n, t.derivative, t.value, c, t.binomial_d, t.binomial_n); };
  const auto by_xi2 = [&](const Rows& c) { return apply(n, t.value, t.derivative, c, t.binomial_n, t.binomial_d); };
  std::array<Derivative, 4> d{by_xi1(x), by_xi2(y), by_xi2(x), by_xi1(y)};
  for (int k = 0; k < 4; ++k) d[k].error = conversion_error(n, d[k], k % 2 == 0 ? size_x : size_y, t);

  BernsteinSquare det{2 * n - 1, std::vector<double>(4 * n * n, 0.0), 0};
  add_product(d[0], d[1], 1, det);
  add_product(d[2], d[3], -1, det);
  for (int j = 0; j < 2 * n; ++j)
    for (int i = 0; i < 2 * n; ++i) det.coefs[j * 2 * n + i] /= t.binomial_det[i] * t.binomial_det[j];
  return det;
}

double lower_bound(const BernsteinSquare& polynomial, int depth) {
  const std::vector<double>& c = polynomial.coefs;
  const auto [least, greatest] = std::minmax_element(c.begin(), c.end());
  const double bound = *least - polynomial.error;
  if (bound > 0 || depth <= 0 || least_corner(polynomial) + polynomial.error <= 0) return bound;

  const double largest = std::max(std::abs(*least), std::abs(*greatest));
  std::array<BernsteinSquare, 4> parts = quarters(polynomial);
  for (BernsteinSquare& part : parts)
    part.error += 2 * polynomial.degree * unit_roundoff * (largest + polynomial.error);
  double result = lower_bound(parts[0], depth - 1);
  for (int k = 1; k < 4; ++k) result = std::min(result, lower_bound(parts[k], depth - 1));
  return result;
}

double least_value(const BernsteinSquare& polynomial, double tolerance) {
  constexpr int max_depth = 20;  // beyond it, coefficients differ by rounding only
  double attained = least_corner(polynomial);
  std::vector<std::pair<BernsteinSquare, int>> open;
  open.emplace_back(polynomial, 0);
  while (!open.empty()) {
    const auto [part, depth] = std::move(open.back());
    open.pop_back();
    if (depth == max_depth || *std::min_element(part.coefs.begin(), part.coefs.end()) >= attained - tolerance) continue;
    for (BernsteinSquare& quarter : quarters(part)) {
      attained = std::min(attained, least_corner(quarter));
      open.emplace_back(std::move(quarter), depth + 1);
    }
  }
  return attained;
}

double quad_jacobian_lower_bound(int order, const Vec2* nodes, int depth) {
  if (const std::optional<BilinearElement> element = as_bilinear(order, nodes))
    if (const std::optional<double> bound = bilinear_lower_bound(order, *element)) return *bound;
  return lower_bound(quad_jacobian_det(order, nodes), depth);
}

double quad_scaled_jacobian(int order, const Vec2* nodes) { return quad_scaled_jacobian_minimum(order, nodes).value; }

ScaledJacobianMinimum quad_scaled_jacobian_minimum(int order, const Vec2* nodes) {
  if (const std::optional<BilinearElement> element = as_bilinear(order, nodes)) return least_at_corners(*element);
  const int count = (order + 1) * (order + 1);
  Vector x(count), y(count);
  for (int k = 0; k < count; ++k) x[k] = nodes[k].x - nodes[0].x, y[k] = nodes[k].y - nodes[0].y;
  const auto dx = sampled_derivatives(order, x), dy = sampled_derivatives(order, y);
  std::vector<double> values(dx[0].size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Vec2 a{dx[0][k], dy[0][k]}, b{dx[1][k], dy[1][k]};
    const double scale = std::sqrt(norm2(a) * norm2(b));
    values[k] = scale > 0 ? cross(a, b) / scale : 0.0;
  }
  const auto [value, xi] = least_sample(values);
  return {value, xi};
}

namespace {

template <typename Point>
Point position_at(int order, const Point* nodes, Vec2 xi) {
  const Eigen::MatrixXd basis = interpolation_matrix(gll_points(order), {xi.x, xi.y});
  Point sum{};
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i <= order; ++i) sum += basis(0, i) * basis(1, j) * nodes[j * (order + 1) + i];
  return sum;
}

}  // namespace

Vec2 quad_position(int order, const Vec2* nodes, Vec2 xi) { return position_at(order, nodes, xi); }
Vec3 quad_position(int order, const Vec3* nodes, Vec2 xi) { return position_at(order, nodes, xi); }

}  // namespace quadrille::spectral
