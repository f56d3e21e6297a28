#include "spectral/tri_bernstein.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../support/bernstein_value.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::spectral {
namespace {

using Lambda = std::array<double, 3>;

Vec2 reference_point(const Lambda& l) { return {l[1] - l[0] - l[2], l[2] - l[0] - l[1]}; }

std::vector<Lambda> sample_points() {
  std::vector<Lambda> points;
  for (int i = 0; i <= 7; ++i)
    for (int j = 0; i + j <= 7; ++j) points.push_back({i / 7.0, j / 7.0, (7 - i - j) / 7.0});
  return points;
}

/// Coefficients of a smooth function's size: they fall with the degree.
std::vector<double> orthogonal_coefs(int order, double phase) {
  std::vector<double> coefs;
  for (int d = 0; d <= order; ++d)
    for (int p = 0; p <= d; ++p) coefs.push_back(std::cos(phase + 1.7 * p + 0.3 * d) / (1 + d * d));
  return coefs;
}

double orthogonal_sum(int order, const std::vector<double>& coefs, const Lambda& l) {
  std::vector<double> modes(coefs.size());
  orthogonal_values(order, reference_point(l), modes.data());
  double sum = 0;
  for (std::size_t i = 0; i < coefs.size(); ++i) sum += coefs[i] * modes[i];
  return sum;
}

/// What rounding may cost: the coefficients of high orders are larger than the polynomial and cancel.
double round_off(const std::vector<double>& b) {
  double size = 1;
  for (const double c : b) size = std::max(size, std::abs(c));
  return 1e-14 * size;
}

class OfOrder : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(TriBernstein, OfOrder, testing::Values(0, 1, 2, 5, 8, 13, 20));

TEST_P(OfOrder, has_the_values_of_the_orthogonal_expansion) {
  const int n = GetParam();
  const std::vector<double> coefs = orthogonal_coefs(n, 0.4), b = bernstein_from_orthogonal(n, coefs);
  for (const Lambda& l : sample_points())
    EXPECT_NEAR(bernstein_value(n, b, l), orthogonal_sum(n, coefs, l), round_off(b));
}

TEST_P(OfOrder, turns_the_constant_into_equal_coefficients) {
  const int n = GetParam();
  std::vector<double> coefs(num_bernstein(n), 0.0);
  coefs[0] = std::sqrt(2.0);
  for (const double c : bernstein_from_orthogonal(n, coefs)) EXPECT_NEAR(c, 1, 1e-15);
}

TEST_P(OfOrder, hull_holds_the_values) {
  const int n = GetParam();
  const std::vector<double> b = bernstein_from_orthogonal(n, orthogonal_coefs(n, 1.1));
  const auto [low, high] = std::minmax_element(b.begin(), b.end());
  for (const Lambda& l : sample_points()) {
    EXPECT_GE(bernstein_value(n, b, l), *low - 1e-14);
    EXPECT_LE(bernstein_value(n, b, l), *high + 1e-14);
  }
}

// The vertices of a child in the parent's barycentric coordinates, by the header's rule.
std::array<Lambda, 3> child_vertices(int child) {
  const std::array<Lambda, 3> vertex{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<Lambda, 3> middle{{{.5, .5, 0}, {0, .5, .5}, {.5, 0, .5}}};
  if (child == 3) return {middle[1], middle[2], middle[0]};
  std::array<Lambda, 3> result;
  result[child] = vertex[child];
  result[(child + 1) % 3] = middle[child];
  result[(child + 2) % 3] = middle[(child + 2) % 3];
  return result;
}

Lambda combine(const std::array<Lambda, 3>& vertices, const Lambda& l) {
  Lambda result{};
  for (int v = 0; v < 3; ++v)
    for (int c = 0; c < 3; ++c) result[c] += l[v] * vertices[v][c];
  return result;
}

TEST_P(OfOrder, children_are_the_parent) {
  const int n = GetParam();
  const std::vector<double> b = bernstein_from_orthogonal(n, orthogonal_coefs(n, 2.2));
  const auto children = bernstein_subdivide(n, b);
  for (int child = 0; child < 4; ++child)
    for (const Lambda& l : sample_points())
      EXPECT_NEAR(bernstein_value(n, children[child], l), bernstein_value(n, b, combine(child_vertices(child), l)),
                  round_off(b));
}

TEST_P(OfOrder, halves_are_the_parent) {
  const int n = GetParam();
  const std::vector<double> b = bernstein_from_orthogonal(n, orthogonal_coefs(n, 0.2));
  std::vector<double> first(b.size()), second(b.size());
  for (int edge = 0; edge < 3; ++edge) {
    bernstein_bisect(n, b.data(), edge, first.data(), second.data());
    const int from = edge, to = (edge + 1) % 3;
    std::array<Lambda, 3> half{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, other = half;
    half[to] = other[from] = {0.5 * (from == 0 || to == 0), 0.5 * (from == 1 || to == 1), 0.5 * (from == 2 || to == 2)};
    for (const Lambda& l : sample_points()) {
      EXPECT_NEAR(bernstein_value(n, first, l), bernstein_value(n, b, combine(half, l)), round_off(b));
      EXPECT_NEAR(bernstein_value(n, second, l), bernstein_value(n, b, combine(other, l)), round_off(b));
    }
  }
}

TEST_P(OfOrder, keeps_its_values_when_elevated) {
  const int n = GetParam();
  const std::vector<double> b = bernstein_from_orthogonal(n, orthogonal_coefs(n, 0.9)), c = bernstein_elevate(n, b);
  for (const Lambda& l : sample_points())
    EXPECT_NEAR(bernstein_value(n + 1, c, l), bernstein_value(n, b, l), round_off(b));
}

TEST(TriBernstein, differentiates_lambda1_squared_lambda2) {
  // b_(0,2,1) of degree 3 belongs to 3 lambda1^2 lambda2: derivatives 6 l1 l2 and 3 l1^2.
  std::vector<double> b(10, 0.0);
  b[bernstein_index(3, 2, 1)] = 1;
  const auto d = bernstein_derivatives(3, b);
  for (const Lambda& l : sample_points()) {
    EXPECT_NEAR(bernstein_value(2, d[0], l), 6 * l[1] * l[2], 1e-15);
    EXPECT_NEAR(bernstein_value(2, d[1], l), 3 * l[1] * l[1], 1e-15);
  }
}

TEST(TriBernstein, multiplies) {
  const std::vector<double> a = bernstein_from_orthogonal(5, orthogonal_coefs(5, 0.7));
  const std::vector<double> b = bernstein_from_orthogonal(8, orthogonal_coefs(8, 1.9));
  const std::vector<double> product = bernstein_product(5, a, 8, b);
  for (const Lambda& l : sample_points())
    EXPECT_NEAR(bernstein_value(13, product, l), bernstein_value(5, a, l) * bernstein_value(8, b, l), 1e-14);
}

TEST(TriBernstein, bounds_an_affine_jacobian_by_itself) {
  // (0,0), (3,0), (0,2): det(dx/dxi) = 6 / 4.
  EXPECT_NEAR(jacobian_lower_bound(1, {0, 3, 0}, {0, 0, 2}), 1.5, 1e-13);
  EXPECT_NEAR(jacobian_lower_bound(1, {0, 0, 3}, {0, 2, 0}), -1.5, 1e-13);
}

/// x = lambda1, y = lambda2 with the middle of edge 0 moved down by `sag`; det(dx/dxi) in closed form.
struct Bent {
  explicit Bent(double s) : sag(s), y{0, -s, 0, 0.5, 0.5, 1} {}
  // y = l2^2 + (l0 + l1) l2 - 2 s l0 l1, x = l1; det = y_2 / 4 with y_2 = 1 + 2 s l1.
  double det(const Lambda& l) const { return (1 + 2 * sag * l[1]) / 4; }
  double sag;
  std::vector<double> x{0, 0.5, 1, 0, 0.5, 0}, y;
};

TEST(TriBernstein, jacobian_bound_is_below_the_jacobian_and_close) {
  for (const double sag : {-0.4, -0.2, 0.3}) {
    const Bent bent(sag);
    double least = 1e9;
    for (const Lambda& l : sample_points()) least = std::min(least, bent.det(l));
    const double bound = jacobian_lower_bound(2, bent.x, bent.y);
    EXPECT_LE(bound, least);
    EXPECT_NEAR(bound, least, 1e-13);
  }
}

TEST(TriBernstein, subdivision_proves_what_the_hull_alone_cannot) {
  // x = xi1-like cubic whose derivative 1 - a l1 (1 - l1) dips to 1 - a / 4 > 0 in the middle of an edge.
  const double a = 3.2;
  std::vector<double> x(10, 0.0), y(10, 0.0);
  for (int k = 0; k <= 3; ++k)
    for (int j = 0; j + k <= 3; ++j) {
      const int i = bernstein_index(3, j, k);
      const double l2 = j * (j - 1) / 6.0, l3 = j == 3 ? 1.0 : 0.0;  // Bernstein coefficients of l1^2, l1^3
      x[i] = j / 3.0 - a * (l2 / 2 - l3 / 3);
      y[i] = k / 3.0;
    }
  EXPECT_LT(jacobian_lower_bound(3, x, y, 0), 0);
  const double bound = jacobian_lower_bound(3, x, y, 4);
  EXPECT_GT(bound, 0);
  EXPECT_LE(bound, (1 - a / 4) / 4);
}

TEST(TriBernstein, a_folded_element_has_no_positive_bound) {
  const Bent bent(-0.6);  // det < 0 at vertex 1
  EXPECT_LT(jacobian_lower_bound(2, bent.x, bent.y, 6), 0);
}

}  // namespace
}  // namespace quadrille::spectral
