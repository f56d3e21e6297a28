#include "spectral/hex_map.hpp"

#include <algorithm>
#include <cmath>

#include "spectral/bernstein_cube.hpp"
#include "spectral/bernstein_tables.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

namespace {

constexpr double cheap_enough = 0.8;  ///< rho up to which the cheap bound is taken: beyond it is far too low
constexpr double lebesgue = 3;        ///< above the constant of the Gauss-Lobatto-Legendre nodes up to order 30

/// Tables that depend on the order only.
struct HexTables {
  std::vector<double> to_bernstein;          ///< nodes -> coefficients, row by row
  double norm;                               ///< of it
  std::vector<double> value, slope;          ///< of the Lagrange polynomials at xi = 0
  std::vector<double> sample, sample_slope;  ///< of those at the samples of scaled Jacobians, row by row
  std::vector<double> binomial_n, binomial_d, binomial_det;

  explicit HexTables(int n) {
    const BernsteinTables& line = bernstein_tables(n);
    to_bernstein.assign(line.value.begin(), line.value.end());
    norm = line.value_norm;
    binomial_n = binomials(n), binomial_d = binomials(n - 1), binomial_det = binomials(3 * n - 1);
    const std::vector<double>& points = gll_points(n);
    std::vector<double> at;
    for (int i = 0; i < n + 3; ++i) at.push_back(-1 + 2.0 * i / (n + 2));
    const Eigen::MatrixXd d = differentiation_matrix(points);
    const auto row_wise = [](const Eigen::MatrixXd& m) {
      std::vector<double> rows;
      for (int r = 0; r < m.rows(); ++r)
        for (int c = 0; c < m.cols(); ++c) rows.push_back(m(r, c));
      return rows;
    };
    const Eigen::MatrixXd centre = interpolation_matrix(points, {0.0}), samples = interpolation_matrix(points, at);
    value = row_wise(centre), slope = row_wise(centre * d);
    sample = row_wise(samples), sample_slope = row_wise(samples * d);
  }
};

/// The matrix acts along the slowest index, which becomes the fastest one of `out`: after three such steps the indices
/// are in their old order. `rest`: values for each value of the slowest index.
void transform(const std::vector<double>& matrix, int rows, int columns, int rest, const double* in, double* out) {
  for (int i = 0; i < rest; ++i)
    for (int r = 0; r < rows; ++r) {
      double sum = 0;
      for (int c = 0; c < columns; ++c) sum += matrix[r * columns + c] * in[c * rest + i];
      out[i * rows + r] = sum;
    }
}

/// One matrix for each direction, the slowest first; `m` rows, `n` columns.
std::vector<double> transformed(const std::array<const std::vector<double>*, 3>& matrices, int m, int n,
                                const double* in) {
  std::vector<double> a(m * n * n), b(m * m * n), out(m * m * m);
  transform(*matrices[0], m, n, n * n, in, a.data());
  transform(*matrices[1], m, n, m * n, a.data(), b.data());
  transform(*matrices[2], m, n, m * m, b.data(), out.data());
  return out;
}

using Norms = std::array<std::array<double, 3>, 3>;  ///< of entries, by row and column

/// The sum of the products of one entry of each row and column.
double permanent(const Norms& g) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int p = (k + 1) % 3, q = (k + 2) % 3;
    sum += g[0][k] * (g[1][p] * g[2][q] + g[1][q] * g[2][p]);
  }
  return sum;
}

/// A, a matrix by rows, and its inverse by columns, exact but for `relative_error`.
struct Scaling {
  std::array<Vec3, 3> rows, inverse;
  double det = 0;             ///< of A
  double relative_error = 0;  ///< of det
};

std::array<Vec3, 3> central_jacobian(int order, const Vec3* nodes, const HexTables& t) {
  std::array<Vec3, 3> columns{};
  const int n = order + 1;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vec3 x = nodes[(k * n + j) * n + i] - nodes[0];
        columns[0] += t.slope[i] * t.value[j] * t.value[k] * x;
        columns[1] += t.value[i] * t.slope[j] * t.value[k] * x;
        columns[2] += t.value[i] * t.value[j] * t.slope[k] * x;
      }
  return columns;
}

double greatest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// By the Jacobian at the centre; if that is singular or reversed, by the element's size.
Scaling scaling_of(int order, const Vec3* nodes, const HexTables& t) {
  const std::array<Vec3, 3> c = central_jacobian(order, nodes, t);
  const auto row = [](Vec3 a, Vec3 b, double det) { return cross(a, b) / det; };
  const double det = dot(c[0], cross(c[1], c[2]));
  Scaling s;
  if (det > 0) {
    s.rows = {row(c[1], c[2], det), row(c[2], c[0], det), row(c[0], c[1], det)};
    s.inverse = c;
    s.det = dot(s.rows[0], cross(s.rows[1], s.rows[2]));
    Norms sizes{};
    for (int r = 0; r < 3; ++r) sizes[r] = {std::abs(s.rows[r].x), std::abs(s.rows[r].y), std::abs(s.rows[r].z)};
    s.relative_error = s.det > 0 ? 8 * unit_roundoff * permanent(sizes) / s.det : 1;
    if (s.relative_error < 1e-3) return s;
  }
  double size = 0;
  for (int k = 0; k < (order + 1) * (order + 1) * (order + 1); ++k)
    size = std::max(size, greatest(nodes[k] - nodes[0]));
  if (!(size > 0)) size = 1;
  s.inverse = {Vec3{size, 0, 0}, Vec3{0, size, 0}, Vec3{0, 0, size}};
  s.rows = {Vec3{1 / size, 0, 0}, Vec3{0, 1 / size, 0}, Vec3{0, 0, 1 / size}};
  s.det = 1 / size / size / size, s.relative_error = 8 * unit_roundoff;
  return s;
}

/// Bernstein coefficients of the components of Z, with a bound of their errors.
struct Deviation {
  std::array<std::vector<double>, 3> coefs;
  std::array<double, 3> errors{};  ///< of each component
};

Deviation deviation_of(int order, const Vec3* nodes, const Scaling& s, const HexTables& t) {
  const int n = order + 1;
  const std::vector<double>& xi = gll_points(order);
  const double middle = xi[n / 2];
  std::array<std::vector<double>, 3> z;
  for (std::vector<double>& component : z) component.resize(n * n * n);
  std::array<double, 3> largest{}, terms{1, 1, 1};  // of Z, and of the sums that give it
  for (int k = 0, at = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i, ++at) {
        const Vec3 x = nodes[at] - nodes[(n / 2 * n + n / 2) * n + n / 2];
        const std::array<double, 3> reference{xi[i] - middle, xi[j] - middle, xi[k] - middle};
        for (int r = 0; r < 3; ++r) {
          const Vec3& a = s.rows[r];
          z[r][at] = dot(a, x) - reference[r];
          terms[r] = std::max(terms[r], std::abs(a.x * x.x) + std::abs(a.y * x.y) + std::abs(a.z * x.z));
          largest[r] = std::max(largest[r], std::abs(z[r][at]));
        }
      }
  Deviation result;
  for (int r = 0; r < 3; ++r) {
    result.coefs[r] = transformed({&t.to_bernstein, &t.to_bernstein, &t.to_bernstein}, n, n, z[r].data());
    const double of_nodes = 8 * unit_roundoff * terms[r], of_sums = (3 * order + 24) * unit_roundoff * largest[r];
    result.errors[r] = t.norm * t.norm * t.norm * (of_nodes + of_sums);
  }
  return result;
}

/// One entry of I + Z', with the binomials of its degrees: `sizes` coefficients along xi1, xi2 and xi3.
struct Entry {
  std::array<int, 3> sizes{};
  std::vector<double> coefs;
  double greatest = 0;
};

/// d Z_r / d xi_c plus `constant`.
Entry entry(int order, const std::vector<double>& coefs, int direction, double constant) {
  const int n = order + 1, step = direction == 0 ? 1 : direction == 1 ? n : n * n;
  Entry e;
  e.sizes = {n, n, n};
  e.sizes[direction] = order;
  e.coefs.reserve(order * n * n);
  for (int k = 0; k < e.sizes[2]; ++k)
    for (int j = 0; j < e.sizes[1]; ++j)
      for (int i = 0; i < e.sizes[0]; ++i) {
        const int at = (k * n + j) * n + i;
        e.coefs.push_back((coefs[at + step] - coefs[at]) * order / 2 + constant);
        e.greatest = std::max(e.greatest, std::abs(e.coefs.back()));
      }
  return e;
}

using Entries = std::array<std::array<Entry, 3>, 3>;

double spectral_bound(const Norms& e) {
  double rows = 0, columns = 0;
  for (int k = 0; k < 3; ++k) {
    rows = std::max(rows, e[k][0] + e[k][1] + e[k][2]);
    columns = std::max(columns, e[0][k] + e[1][k] + e[2][k]);
  }
  return std::min(rows, columns);
}

void scale(Entry& e, const HexTables& t, int direction) {
  const auto& b = [&](int d) -> const std::vector<double>& { return d == direction ? t.binomial_d : t.binomial_n; };
  std::size_t at = 0;
  for (int k = 0; k < e.sizes[2]; ++k)
    for (int j = 0; j < e.sizes[1]; ++j)
      for (int i = 0; i < e.sizes[0]; ++i) e.coefs[at++] *= b(0)[i] * b(1)[j] * b(2)[k];
}

void add_product(const Entry& a, const Entry& b, double sign, Entry& out) {
  for (int k = 0, at = 0; k < a.sizes[2]; ++k)
    for (int j = 0; j < a.sizes[1]; ++j)
      for (int i = 0; i < a.sizes[0]; ++i, ++at) {
        const double factor = sign * a.coefs[at];
        const double* from = b.coefs.data();
        for (int kb = 0; kb < b.sizes[2]; ++kb)
          for (int jb = 0; jb < b.sizes[1]; ++jb, from += b.sizes[0]) {
            double* to = &out.coefs[((k + kb) * out.sizes[1] + j + jb) * out.sizes[0] + i];
            for (int ib = 0; ib < b.sizes[0]; ++ib) to[ib] += factor * from[ib];
          }
      }
}

Entry empty_product(const Entry& a, const Entry& b) {
  Entry out;
  for (int d = 0; d < 3; ++d) out.sizes[d] = a.sizes[d] + b.sizes[d] - 1;
  out.coefs.assign(static_cast<std::size_t>(out.sizes[0]) * out.sizes[1] * out.sizes[2], 0.0);
  return out;
}

/// Each coefficient of det is a sum of six convex combinations of products of three entries: errors of these enter with
/// weight one, and so does the rounding of both sums. `errors`: of the entries of each row.
double det_error(int order, const Entries& e, const std::array<double, 3>& errors) {
  Norms exact{}, widened{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) exact[r][c] = e[r][c].greatest, widened[r][c] = exact[r][c] + errors[r];
  const double terms = 4.0 * (order + 1) * (order + 1) * order + 40;
  return permanent(widened) - permanent(exact) + (terms + 32) * unit_roundoff * permanent(widened);
}

BernsteinCube det_of(int order, Entries e, const std::array<double, 3>& errors, const HexTables& t) {
  const double error = det_error(order, e, errors);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) scale(e[r][c], t, c);
  Entry det;
  for (int r = 0; r < 3; ++r) {
    const int p = (r + 1) % 3, q = (r + 2) % 3;
    Entry minor = empty_product(e[p][1], e[q][2]);
    add_product(e[p][1], e[q][2], 1, minor);
    add_product(e[q][1], e[p][2], -1, minor);
    if (r == 0) det = empty_product(e[0][0], minor);
    add_product(e[r][0], minor, 1, det);
  }
  const int width = 3 * order;
  std::size_t at = 0;
  for (int k = 0; k < width; ++k)
    for (int j = 0; j < width; ++j)
      for (int i = 0; i < width; ++i) det.coefs[at++] /= t.binomial_det[i] * t.binomial_det[j] * t.binomial_det[k];
  return {3 * order - 1, std::move(det.coefs), error};
}

}  // namespace

HexBounds hex_bounds(int order, const Vec3* nodes, int depth) {
  const HexTables& t = table_per_order<HexTables>(order);
  const Scaling s = scaling_of(order, nodes, t);
  const Deviation z = deviation_of(order, nodes, s, t);
  Norms norms{};
  std::array<double, 3> errors{};  // of the entries of each row
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double g = entry(order, z.coefs[r], c, 0).greatest;
      errors[r] = std::max(errors[r], order * z.errors[r] + 8 * unit_roundoff * (1 + g));
      norms[r][c] = g + errors[r];
    }
  HexBounds bounds;
  for (int c = 0; c < 3; ++c) {
    double sum = 0;
    for (int r = 0; r < 3; ++r) sum += norm(s.inverse[r]) * (norms[r][c] + (r == c ? 1 : 0));
    bounds.derivatives[c] = 1.01 * sum;  // s.inverse is rounded
  }
  const double rho = spectral_bound(norms);
  double bound = (1 - rho) * (1 - rho) * (1 - rho) * (1 - 8 * unit_roundoff);
  if (!(rho <= cheap_enough)) {
    Entries e;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) e[r][c] = entry(order, z.coefs[r], c, r == c ? 1 : 0);
    bound = lower_bound(det_of(order, std::move(e), errors, t), depth);
  }
  bounds.jacobian = bound / (s.det * (bound > 0 ? 1 + 2 * s.relative_error : 1 - 2 * s.relative_error));
  return bounds;
}

double moved_jacobian_bound(int order, const HexBounds& bounds, double node_distance) {
  // Markov's inequality for the polynomial through the differences of the nodes.
  const double d = order * order * lebesgue * lebesgue * lebesgue * node_distance;
  const auto [a, b, c] = bounds.derivatives;
  return bounds.jacobian - d * (a * b + b * c + c * a + d * (a + b + c) + d * d);
}

double hex_scaled_jacobian(int order, const Vec3* nodes) {
  const HexTables& t = table_per_order<HexTables>(order);
  const int n = order + 1, m = order + 3, count = n * n * n;
  std::vector<double> x(3 * count);
  for (int k = 0; k < count; ++k) {
    const Vec3 own = nodes[k] - nodes[0];
    x[k] = own.x, x[count + k] = own.y, x[2 * count + k] = own.z;
  }
  std::array<std::array<std::vector<double>, 3>, 3> d;  // by direction and coordinate
  for (int c = 0; c < 3; ++c) {
    const double* from = &x[c * count];
    d[0][c] = transformed({&t.sample, &t.sample, &t.sample_slope}, m, n, from);
    d[1][c] = transformed({&t.sample, &t.sample_slope, &t.sample}, m, n, from);
    d[2][c] = transformed({&t.sample_slope, &t.sample, &t.sample}, m, n, from);
  }
  double least = 1;
  for (int k = 0; k < m * m * m; ++k) {
    const auto at = [&](int direction) { return Vec3{d[direction][0][k], d[direction][1][k], d[direction][2][k]}; };
    const Vec3 a = at(0), b = at(1), c = at(2);
    const double size = std::sqrt(norm2(a) * norm2(b) * norm2(c));
    least = std::min(least, size > 0 ? dot(a, cross(b, c)) / size : 0);
  }
  return least > 0 ? least : -1;
}

}  // namespace quadrille::spectral
