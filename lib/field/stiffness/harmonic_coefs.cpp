#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "spectral/jacobi.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"
#include "stiffness/harmonic_element.hpp"
#include "stiffness/harmonic_frame.hpp"

namespace quadrille::stiffness {
namespace {

// The collapsed Gauss rule that is exact for a mode of order P times a polynomial of degree P + 6.
constexpr int num_points(int order) { return (order + harmonic_degree(order)) / 2 + 1; }

// The projection of values at the points onto the orthogonal basis, in two steps, because mode (p, q) is a function of
// eta1 and p times one of eta2, p and q.
struct ProjectionTable {
  std::vector<Vec2> points;             ///< reference coordinates, eta1 fastest
  Eigen::MatrixXd across;               ///< p = 0 .. P x points eta1
  std::vector<Eigen::MatrixXd> upward;  ///< by p: q = 0 .. P - p x points eta2
  Eigen::MatrixXd trace;                ///< boundary modes x orthogonal modes
};

// The boundary modes of each orthogonal mode: values at the vertices and, with psi' of norm 1, integrals along the
// edges of the slopes times those of the edge modes.
Eigen::MatrixXd make_trace(int order) {
  const int num_modes = spectral::num_tri_modes(order);
  const spectral::Quadrature rule = spectral::gauss_legendre(order);
  Eigen::MatrixXd trace = Eigen::MatrixXd::Zero(spectral::num_boundary_modes(order), num_modes);
  Eigen::VectorXd f(num_modes), f1(num_modes), f2(num_modes);
  for (int edge = 0; edge < 3; ++edge) {
    spectral::orthogonal_values(order, spectral::tri_edge_point(edge, 0), f.data());
    trace.row(edge) = f;
    const Vec2 along = (spectral::tri_edge_point(edge, 1) - spectral::tri_edge_point(edge, 0)) / 2;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double s = rule.points[i];
      const Vec2 xi = spectral::tri_edge_point(edge, (1 + s) / 2);
      spectral::orthogonal_gradients(order, xi, f.data(), f1.data(), f2.data());
      const Eigen::RowVectorXd slopes = rule.weights[i] * (along.x * f1 + along.y * f2).transpose();
      for (int d = 2; d <= order; ++d)
        trace.row(spectral::edge_mode(order, edge, d)) -=
            std::sqrt((2 * d - 1) / 2.0) * spectral::jacobi(d - 1, 0, 0, s) * slopes;
    }
  }
  return trace;
}

ProjectionTable make_projection_table(int order) {
  const int n = num_points(order);
  const spectral::Quadrature eta1 = spectral::gauss_legendre(n), eta2 = spectral::gauss_jacobi(n, 1, 0);
  ProjectionTable table{{}, Eigen::MatrixXd(order + 1, n), {}, make_trace(order)};
  for (int p = 0; p <= order; ++p) {
    Eigen::MatrixXd upward(order - p + 1, n);
    for (int i = 0; i < n; ++i) {
      table.across(p, i) = eta1.weights[i] * spectral::jacobi(p, 0, 0, eta1.points[i]);
      const double y = eta2.points[i], weight = std::pow((1 - y) / 2, p) * eta2.weights[i] / 2;
      for (int q = 0; q <= order - p; ++q)
        upward(q, i) = weight * spectral::orthogonal_scale(p, q) * spectral::jacobi(q, 2 * p + 1, 0, y);
    }
    table.upward.push_back(std::move(upward));
  }
  for (const double y : eta2.points) {
    for (const double x : eta1.points) table.points.push_back({(1 + x) * (1 - y) / 2 - 1, y});
  }
  return table;
}

const ProjectionTable& projection_table(int order) {
  static spectral::PerOrder<ProjectionTable> tables(make_projection_table);
  return tables[order];
}

// The modes of maps of one order at the points.
const Eigen::MatrixXd& map_modes(int order, int map_order) {
  static spectral::PerOrder<Eigen::MatrixXd> tables(
      [](int key) { return spectral::orthogonal_vandermonde(key % 100, projection_table(key / 100).points); });
  return tables[100 * order + map_order];
}

// Points are treated in groups, whose sums stay in registers.
constexpr Eigen::Index group = 16;
using Group = Eigen::Array<double, group, 1>;

// The points as z = x + i y, padded to whole groups.
struct Points {
  Eigen::ArrayXd x, y;
};

Points points_of(const spectral::TriMap& map, const HarmonicFrame& frame, int order) {
  const Eigen::MatrixXd& table = map_modes(order, map.order());
  const Eigen::Map<const Eigen::VectorXd> x(map.coefs_x().data(), table.cols()), y(map.coefs_y().data(), table.cols());
  const Eigen::Index n = table.rows(), padded = (n + group - 1) / group * group;
  const Eigen::ArrayXd dx = (table * x).array() - frame.centre.x, dy = (table * y).array() - frame.centre.y;
  Points z{Eigen::ArrayXd::Zero(padded), Eigen::ArrayXd::Zero(padded)};
  z.x.head(n) = frame.scale.real() * dx - frame.scale.imag() * dy;
  z.y.head(n) = frame.scale.real() * dy + frame.scale.imag() * dx;
  return z;
}

// Re of the sum of (a_k - i b_k) p_k at the points, for coefficients a_1, b_1, a_2, ...: Clenshaw's algorithm.
Eigen::ArrayXd values_at(const Points& z, std::complex<double> b, const Eigen::VectorXd& coefs) {
  Eigen::ArrayXd values(z.x.size());
  for (Eigen::Index first = 0; first < values.size(); first += group) {
    const Group x = z.x.segment<group>(first), y = z.y.segment<group>(first);
    Group re = Group::Zero(), im = re, re1 = re, im1 = re, re2 = re, im2 = re;
    for (Eigen::Index k = coefs.size() - 2; k >= 0; k -= 2) {
      const Group re0 = x * re - y * im - b.real() * re1 + b.imag() * im1 - (1.0 / 3) * re2 + coefs[k];
      const Group im0 = x * im + y * re - b.real() * im1 - b.imag() * re1 - (1.0 / 3) * im2 - coefs[k + 1];
      re2 = re1, im2 = im1;
      re1 = re, im1 = im;
      re = re0, im = im0;
    }
    values.segment<group>(first) = x * re - y * im - b.real() * re1 + b.imag() * im1 - (1.0 / 3) * re2;
  }
  return values;
}

// Projects the values at the points onto the orthogonal basis.
void project(const ProjectionTable& table, const Eigen::ArrayXd& values, Eigen::Ref<Eigen::VectorXd> coefs) {
  const Eigen::Index n = table.across.cols();
  const Eigen::MatrixXd across =
      Eigen::Map<const Eigen::MatrixXd>(values.data(), n, n).transpose() * table.across.transpose();  // points eta2 x p
  for (int p = 0; p < static_cast<int>(table.upward.size()); ++p) {
    const Eigen::VectorXd upward = table.upward[p] * across.col(p);
    for (int q = 0; q < upward.size(); ++q) coefs[(p + q) * (p + q + 1) / 2 + p] = upward[q];
  }
}

}  // namespace

Eigen::MatrixXd harmonic_coefs(const spectral::TriMap& map, int order, const Eigen::MatrixXd& projection,
                               const Eigen::MatrixXd& boundary) {
  const ProjectionTable& table = projection_table(order);
  const HarmonicFrame frame(map);
  const Points z = points_of(map, frame, order);
  const Eigen::MatrixXd polynomials = projection * boundary;
  Eigen::MatrixXd coefs(spectral::num_tri_modes(order), boundary.cols());
  for (Eigen::Index column = 0; column < boundary.cols(); ++column)
    project(table, values_at(z, frame.b, polynomials.col(column)), coefs.col(column));
  coefs += equilateral(order).extension * (boundary - table.trace * coefs);
  return coefs;
}

}  // namespace quadrille::stiffness
