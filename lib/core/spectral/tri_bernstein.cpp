#include "spectral/tri_bernstein.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "spectral/per_order.hpp"

namespace quadrille::spectral {
namespace {

constexpr int max_order = 64;

/// C(n, k) for n <= max_order: exact below 2^64, to an ulp of long double above.
long double binomial(int n, int k) {
  static const std::vector<long double> table = [] {
    constexpr int rows = 2 * max_order + 2;
    std::vector<long double> t(rows * rows, 0);
    for (int r = 0; r < rows; ++r) {
      t[r * rows] = 1;
      for (int c = 1; c <= r; ++c) t[r * rows + c] = t[(r - 1) * rows + c - 1] + (c < r ? t[(r - 1) * rows + c] : 0);
    }
    return t;
  }();
  return k < 0 || k > n ? 0 : table[n * (2 * max_order + 2) + k];
}

/// n! / (i! j! k!).
long double multinomial(int n, int j, int k) { return binomial(n, k) * binomial(n - k, j); }

/// Monomials lambda0^i lambda1^j lambda2^k of degree n, ranked as the Bernstein coefficients.
using Form = std::vector<long double>;

/// Mode (p, q) of the orthogonal basis as a form of degree p + q. With lambda0 + lambda1 = 1 - lambda2:
/// P_p (1 - lambda2)^p = sum_a (-1)^(p-a) C(p,a)^2 lambda1^a lambda0^(p-a),
/// P_q^(2p+1,0)        = sum_s (-1)^s C(q+2p+1,q-s) C(q,s) (lambda0 + lambda1)^s lambda2^(q-s).
/// All coefficients are integers: no rounding while they stay below 2^64.
Form orthogonal_mode(int p, int q) {
  const int n = p + q;
  Form form(num_bernstein(n), 0);
  std::vector<long double> legendre(n + 1, 0);  // P_p's form times (lambda0 + lambda1)^s, by the power of lambda1
  for (int a = 0; a <= p; ++a) legendre[a] = ((p - a) % 2 ? -1 : 1) * binomial(p, a) * binomial(p, a);
  for (int s = 0; s <= q; ++s) {
    const long double jacobi = (s % 2 ? -1 : 1) * binomial(q + 2 * p + 1, q - s) * binomial(q, s);
    for (int j = 0; j <= p + s; ++j) form[bernstein_index(n, j, q - s)] = jacobi * legendre[j];
    for (int j = p + s + 1; j > 0 && j <= n; --j) legendre[j] += legendre[j - 1];
  }
  const long double scale = std::sqrt((2 * p + 1) * (n + 1) / 2.0L);
  for (long double& c : form) c *= scale;
  return form;
}

/// Bernstein coefficients of the modes of degree `order`, in that degree: [p * num_bernstein + coefficient].
std::vector<double> modes_of_degree(int order) {
  if (order < 0 || order > max_order) throw Defect("no Bernstein form for order " + std::to_string(order));
  std::vector<double> table;
  for (int p = 0; p <= order; ++p) {
    const Form form = orthogonal_mode(p, order - p);
    for (int k = 0, i = 0; k <= order; ++k)
      for (int j = 0; j + k <= order; ++j, ++i)
        table.push_back(static_cast<double>(form[i] / multinomial(order, j, k)));
  }
  return table;
}

/// Adds up to four modes, in their order: each sum is loaded and stored once for all.
void add_modes(int num, const double* coefs, const double* modes, std::vector<double>& sums) {
  const std::size_t size = sums.size();
  double* const sum = sums.data();
  if (num == 4) {
    const double a = coefs[0], b = coefs[1], c = coefs[2], d = coefs[3];
    const double *m = modes, *n = m + size, *o = n + size, *p = o + size;
    for (std::size_t i = 0; i < size; ++i) sum[i] = sum[i] + a * m[i] + b * n[i] + c * o[i] + d * p[i];
    return;
  }
  for (int k = 0; k < num; ++k, modes += size) {
    const double coef = coefs[k];
    for (std::size_t i = 0; i < size; ++i) sum[i] += coef * modes[i];
  }
}

/// Position in the coefficients of entry t = 0..m on the line parallel to `edge` that has n - m as the third exponent.
int line_index(int order, int edge, int m, int t) {
  if (edge == 0) return bernstein_index(order, t, order - m);
  if (edge == 1) return bernstein_index(order, m - t, t);
  return bernstein_index(order, order - m, m - t);
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] - b[i];
  return result;
}

double largest(const std::vector<double>& a) {
  double result = 0;
  for (const double c : a) result = std::max(result, std::abs(c));
  return result;
}

/// Least coefficient over the leaves of a subdivision, which is refined while this can raise the bound.
double lower_bound(int order, const std::vector<double>& coefs, int depth) {
  const double hull = *std::min_element(coefs.begin(), coefs.end());
  const double vertices = std::min({coefs[0], coefs[order], coefs.back()});
  if (hull > 0 || depth == 0 || vertices <= 0) return hull;
  double bound = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& child : bernstein_subdivide(order, coefs))
    bound = std::min(bound, lower_bound(order, child, depth - 1));
  return bound;
}

}  // namespace

std::vector<double> bernstein_from_orthogonal(int order, const double* coefs) {
  static PerOrder<std::vector<double>> tables(modes_of_degree);
  std::vector<double> result;
  for (int degree = 0; degree <= order; ++degree) {
    result = degree == 0 ? std::vector<double>{0.0} : bernstein_elevate(degree - 1, result);
    const double* mode = tables[degree].data();
    for (int p = 0; p <= degree;) {
      const int num = std::min(4, degree + 1 - p);
      add_modes(num, coefs, mode, result);
      p += num, coefs += num, mode += num * result.size();
    }
  }
  return result;
}

std::vector<double> bernstein_from_orthogonal(int order, const std::vector<double>& coefs) {
  return bernstein_from_orthogonal(order, coefs.data());
}

void bernstein_bisect(int order, const double* coefs, int edge, double* first, double* second) {
  std::array<double, 2 * max_order + 1> line;
  for (int m = 0; m <= order; ++m) {
    for (int t = 0; t <= m; ++t) line[t] = coefs[line_index(order, edge, m, t)];
    for (int step = 0; step <= m; ++step) {
      first[line_index(order, edge, m, step)] = line[0];
      second[line_index(order, edge, m, m - step)] = line[m - step];
      for (int t = 0; t < m - step; ++t) line[t] = 0.5 * (line[t] + line[t + 1]);
    }
  }
}

std::array<std::vector<double>, 4> bernstein_subdivide(int order, const std::vector<double>& coefs) {
  const std::size_t size = coefs.size();
  std::array<std::vector<double>, 4> children;
  children.fill(std::vector<double>(size));
  std::vector<double> rest(size);
  for (int c = 0; c < 3; ++c) {  // cut both edges of vertex c
    bernstein_bisect(order, coefs.data(), c, children[c].data(), rest.data());
    bernstein_bisect(order, children[c].data(), (c + 2) % 3, rest.data(), children[c].data());
  }
  // Middle child: coefficient (i, j, k) is the blossom at mid edge 1 (i times), mid edge 2 (j), mid edge 0 (k). After i
  // steps of de Casteljau at mid edge 1, the others lie on that polynomial's edge from mid edge 0 to mid edge 2.
  std::vector<double> polynomial = coefs, corner(size);
  for (int i = 0; i <= order; ++i) {
    const int degree = order - i;
    bernstein_bisect(degree, polynomial.data(), 0, corner.data(), rest.data());
    bernstein_bisect(degree, corner.data(), 2, rest.data(), corner.data());
    for (int k = 0; k <= degree; ++k)
      children[3][bernstein_index(order, degree - k, k)] = corner[bernstein_index(degree, k, degree - k)];
    for (int k = 0, at = 0; k < degree; ++k)
      for (int j = 0; j + k < degree; ++j, ++at)
        polynomial[at] =
            0.5 * (polynomial[bernstein_index(degree, j + 1, k)] + polynomial[bernstein_index(degree, j, k + 1)]);
  }
  return children;
}

std::array<std::vector<double>, 2> bernstein_derivatives(int order, const std::vector<double>& coefs) {
  if (order == 0) return {std::vector<double>{0.0}, std::vector<double>{0.0}};
  std::array<std::vector<double>, 2> result;
  for (std::vector<double>& r : result) r.reserve(num_bernstein(order - 1));
  for (int k = 0; k < order; ++k)
    for (int j = 0; j + k < order; ++j) {
      const double base = coefs[bernstein_index(order, j, k)];
      result[0].push_back(order * (coefs[bernstein_index(order, j + 1, k)] - base));
      result[1].push_back(order * (coefs[bernstein_index(order, j, k + 1)] - base));
    }
  return result;
}

std::vector<double> bernstein_product(int order_a, const std::vector<double>& a, int order_b,
                                      const std::vector<double>& b) {
  const int order = order_a + order_b;
  const auto scaled = [](int n, std::vector<double> c) {
    for (int k = 0, i = 0; k <= n; ++k)
      for (int j = 0; j + k <= n; ++j, ++i) c[i] *= static_cast<double>(multinomial(n, j, k));
    return c;
  };
  const std::vector<double> left = scaled(order_a, a), right = scaled(order_b, b);
  std::vector<double> result(num_bernstein(order), 0.0);
  for (int ka = 0, i = 0; ka <= order_a; ++ka)
    for (int ja = 0; ja + ka <= order_a; ++ja, ++i)
      for (int kb = 0, n = 0; kb <= order_b; ++kb) {
        double* row = &result[bernstein_index(order, ja, ka + kb)];
        for (int jb = 0; jb + kb <= order_b; ++jb, ++n) row[jb] += left[i] * right[n];
      }
  for (int k = 0, i = 0; k <= order; ++k)
    for (int j = 0; j + k <= order; ++j, ++i) result[i] /= static_cast<double>(multinomial(order, j, k));
  return result;
}

std::vector<double> bernstein_elevate(int order, const std::vector<double>& coefs) {
  const int n = order + 1;
  std::vector<double> result(num_bernstein(n));
  double* to = result.data();
  const double *row = coefs.data(), *below = row;  // of the third exponents k and k - 1
  for (int k = 0; k <= n; ++k) {
    const int last = n - k;
    // Between the ends every neighbour exists: a loop without branches, for vector instructions.
    for (int j = 1; j < last; ++j) to[j] = ((last - j) * row[j] + j * row[j - 1] + k * below[j]) / n;
    to[0] = ((last > 0 ? last * row[0] : 0) + (k > 0 ? k * below[0] : 0)) / n;
    if (last > 0) to[last] = (last * row[last - 1] + (k > 0 ? k * below[last] : 0)) / n;
    below = row, row += last, to += last + 1;
  }
  return result;
}

double jacobian_lower_bound(int order, const std::vector<double>& x, const std::vector<double>& y, int depth) {
  const auto dx = bernstein_derivatives(order, x), dy = bernstein_derivatives(order, y);
  const int n = order - 1;
  std::vector<double> det = difference(bernstein_product(n, dx[0], n, dy[1]), bernstein_product(n, dx[1], n, dy[0]));
  for (double& c : det) c /= 4;  // the reference edges have length 2
  // Each coefficient is a convex combination of at most (n+1)(n+2)/2 products, and so is each step of a subdivision.
  const double eps = std::numeric_limits<double>::epsilon();
  const double slope_x = std::max(largest(dx[0]), largest(dx[1])), slope_y = std::max(largest(dy[0]), largest(dy[1]));
  const double error_x = eps * order * largest(x), error_y = eps * order * largest(y);
  const double error =
      0.5 * (slope_x * error_y + slope_y * error_x) + eps * slope_x * slope_y * (num_bernstein(n) + 6 + 4 * depth * n);
  for (double& c : det) c -= error;
  return lower_bound(2 * n, det, depth);
}

}  // namespace quadrille::spectral
