#include "stiffness/harmonic_element.hpp"

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"
#include "stiffness/harmonic_frame.hpp"

namespace quadrille::stiffness {
namespace {

constexpr int extra_points = 6;  // on curved edges

/// Gauss points along the edges of elements of order P, for the integrals of harmonic polynomials by boundary modes.
struct EdgeRule {
  spectral::Quadrature rule;
  /// Points x 2 P: the traces of the mode of the first vertex, of that of the last, and of the edge modes of degree
  /// 2 .. P; then the slopes of these edge modes, which are orthonormal.
  Eigen::MatrixXd modes;
};

EdgeRule make_edge_rule(int order, int num_points) {
  EdgeRule edge{spectral::gauss_legendre(num_points), Eigen::MatrixXd(num_points, 2 * order)};
  std::vector<double> values(order);
  const spectral::JacobiPolynomials legendre(order - 1, 0, 0);
  for (int i = 0; i < num_points; ++i) {
    const double s = edge.rule.points[i];
    const std::vector<double> slopes = legendre.all(s);
    spectral::edge_mode_values(order, s, values.data());
    edge.modes(i, 0) = (1 - s) / 2;
    edge.modes(i, 1) = (1 + s) / 2;
    for (int d = 2; d <= order; ++d) {
      edge.modes(i, d) = values[d - 2];
      edge.modes(i, order + d - 1) = -std::sqrt((2 * d - 1) / 2.0) * slopes[d - 1];
    }
  }
  return edge;
}

// Exact for straight edges; with more points for curved ones.
const EdgeRule& edge_rule(int order, bool is_curved) {
  static spectral::PerOrder<EdgeRule> straight([](int n) { return make_edge_rule(n, harmonic_degree(n)); });
  static spectral::PerOrder<EdgeRule> curved(
      [](int n) { return make_edge_rule(n, harmonic_degree(n) + extra_points); });
  return is_curved ? curved[order] : straight[order];
}

// The modes of maps of one order along the edges.
struct MapTable {
  Eigen::MatrixXd values, slopes;  ///< points of edges 0, 1, 2 x modes
};

MapTable make_map_table(const std::vector<double>& points, int map_order) {
  const int n = static_cast<int>(points.size()), num_modes = spectral::num_tri_modes(map_order);
  MapTable table{Eigen::MatrixXd(3 * n, num_modes), Eigen::MatrixXd(3 * n, num_modes)};
  Eigen::VectorXd f(num_modes), f1(num_modes), f2(num_modes);
  for (int edge = 0; edge < 3; ++edge) {
    const Vec2 along = (spectral::tri_edge_point(edge, 1) - spectral::tri_edge_point(edge, 0)) / 2;
    for (int i = 0; i < n; ++i) {
      const Vec2 xi = spectral::tri_edge_point(edge, (1 + points[i]) / 2);
      spectral::orthogonal_gradients(map_order, xi, f.data(), f1.data(), f2.data());
      table.values.row(edge * n + i) = f;
      table.slopes.row(edge * n + i) = along.x * f1 + along.y * f2;
    }
  }
  return table;
}

const MapTable& map_table(int order, int map_order) {
  static spectral::PerOrder<MapTable> tables(
      [](int key) { return make_map_table(edge_rule(key / 100, true).rule.points, key % 100); });
  return tables[100 * order + map_order];
}

using Vector = Eigen::Map<const Eigen::VectorXd>;
Vector as_vector(const std::vector<double>& values) { return {values.data(), std::ssize(values)}; }

struct HarmonicLimits {
  double most_slender = 3;      // beyond that the substitute D is too far off
  double least_pivot = 1e-8;    // part of a polynomial's energy that those of lower degree do not represent
  double largest_radius = 2.5;  // |z| in a curved element; at the vertices of an equilateral one it is 1.37
};
constexpr HarmonicLimits harmonic_limits;

// The points of edges 0, 1 and 2, counter-clockwise, then the vertices; and the weights times the derivative of z, 0 at
// the vertices.
struct EdgePoints {
  Eigen::ArrayXcd z, dz;
};

EdgePoints edge_points(const spectral::TriMap& map, const HarmonicFrame& frame, int order) {
  const spectral::Quadrature& rule = edge_rule(order, !map.is_affine()).rule;
  const Eigen::ArrayXd s = as_vector(rule.points), weights = as_vector(rule.weights);
  const Eigen::Index n = s.size();
  EdgePoints points{Eigen::ArrayXcd(3 * n + 3), Eigen::ArrayXcd::Zero(3 * n + 3)};
  auto vertices = points.z.tail<3>();
  for (int k = 0; k < 3; ++k) vertices[k] = frame(map.position(spectral::tri_edge_point(k, 0)));
  if (map.is_affine()) {
    for (int edge = 0; edge < 3; ++edge) {
      const std::complex<double> begin = vertices[edge], end = vertices[(edge + 1) % 3];
      points.z.segment(edge * n, n) = (begin + end) / 2.0 + (end - begin) / 2.0 * s;
      points.dz.segment(edge * n, n) = (end - begin) / 2.0 * weights;
    }
    return points;
  }
  const MapTable& table = map_table(order, map.order());
  const Vector x = as_vector(map.coefs_x()), y = as_vector(map.coefs_y());
  Eigen::ArrayXcd z(3 * n), dz(3 * n);
  z.real() = (table.values * x).array() - frame.centre.x;
  z.imag() = (table.values * y).array() - frame.centre.y;
  dz.real() = (table.slopes * x).array() * weights.replicate(3, 1);
  dz.imag() = (table.slopes * y).array() * weights.replicate(3, 1);
  points.z.head(3 * n) = z * frame.scale;
  points.dz.head(3 * n) = dz * frame.scale;
  return points;
}

// Re p_1, Im p_1, Re p_2, ... at the points, and their normal derivatives times the weights.
struct EdgeValues {
  Eigen::MatrixXd values, fluxes;  ///< points x 2 degree
};

// The normal derivatives of Re p and Im p are the derivatives of Im p and -Re p along the edge.
EdgeValues edge_values(const EdgePoints& at, std::complex<double> b, int degree) {
  const Eigen::Index n = at.z.size();
  EdgeValues of{Eigen::MatrixXd(n, 2 * degree), Eigen::MatrixXd(n, 2 * degree)};
  Eigen::ArrayXcd p = Eigen::ArrayXcd::Ones(n), p1 = Eigen::ArrayXcd::Zero(n), p2 = p1, dp = p1, dp1 = p1, dp2 = p1,
                  next;
  for (int k = 0; k < degree; ++k) {
    next = next_polynomial(at.z, b, dp, dp1, dp2) + at.dz * p;
    dp2.swap(dp1), dp1.swap(dp), dp.swap(next);
    next = next_polynomial(at.z, b, p, p1, p2);
    p2.swap(p1), p1.swap(p), p.swap(next);
    of.values.col(2 * k) = p.real();
    of.values.col(2 * k + 1) = p.imag();
    of.fluxes.col(2 * k) = dp.imag();
    of.fluxes.col(2 * k + 1) = -dp.real();
  }
  return of;
}

// The polynomials and the boundary modes: a row or a column for each polynomial.
struct Products {
  Eigen::MatrixXd flux;   ///< a(polynomial, mode), polynomials x modes
  Eigen::MatrixXd trace;  ///< T, modes x polynomials
};

// The coefficient of an edge mode is the integral of the slopes of the trace times those of the mode.
Products products_with_modes(const EdgeValues& at, const EdgeRule& edge, int order) {
  const Eigen::Index num = at.fluxes.cols(), n = edge.modes.rows(), num_edge = order - 1;
  const int nb = spectral::num_boundary_modes(order);
  Products products{Eigen::MatrixXd::Zero(num, nb), Eigen::MatrixXd(nb, num)};
  for (int k = 0; k < 3; ++k) {
    const int first = 3 + k * (order - 1);
    const Eigen::MatrixXd of_edge = at.fluxes.middleRows(k * n, n).transpose() * edge.modes;
    products.flux.col(k) += of_edge.col(0);
    products.flux.col((k + 1) % 3) += of_edge.col(1);
    products.flux.middleCols(first, num_edge) = of_edge.middleCols(2, num_edge);
    for (Eigen::Index re = 0; re < num; re += 2) {
      products.trace.col(re).segment(first, num_edge) = -of_edge.row(re + 1).tail(num_edge);
      products.trace.col(re + 1).segment(first, num_edge) = of_edge.row(re).tail(num_edge);
    }
  }
  products.trace.topRows<3>() = at.values.bottomRows<3>();
  return products;
}

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
  const EdgeRule edge = make_edge_rule(order, order);
  const MapTable modes = make_map_table(edge.rule.points, order);
  const Eigen::Index n = edge.modes.rows(), num_edge = order - 1;
  const Eigen::MatrixXd weighted = as_vector(edge.rule.weights).asDiagonal() * edge.modes.rightCols(num_edge);
  Eigen::MatrixXd trace(spectral::num_boundary_modes(order), spectral::num_tri_modes(order));
  Eigen::VectorXd at_vertex(trace.cols());
  for (int k = 0; k < 3; ++k) {
    spectral::orthogonal_values(order, spectral::tri_edge_point(k, 0), at_vertex.data());
    trace.row(k) = at_vertex;
    trace.middleRows(3 + k * num_edge, num_edge) = weighted.transpose() * modes.slopes.middleRows(k * n, n);
  }
  return trace;
}

ProjectionTable make_projection_table(int order) {
  const int n = num_points(order);
  const spectral::Quadrature eta1 = spectral::gauss_legendre(n), eta2 = spectral::gauss_jacobi(n, 1, 0);
  ProjectionTable table{{}, Eigen::MatrixXd(order + 1, n), {}, make_trace(order)};
  const spectral::JacobiPolynomials legendre(order, 0, 0);
  for (int i = 0; i < n; ++i) table.across.col(i) = eta1.weights[i] * as_vector(legendre.all(eta1.points[i]));
  for (int p = 0; p <= order; ++p) {
    Eigen::MatrixXd upward(order - p + 1, n);
    const spectral::JacobiPolynomials polynomials(order - p, 2 * p + 1, 0);
    for (int i = 0; i < n; ++i) {
      const double y = eta2.points[i], weight = std::pow((1 - y) / 2, p) * eta2.weights[i] / 2;
      const std::vector<double> values = polynomials.all(y);
      for (int q = 0; q <= order - p; ++q) upward(q, i) = weight * spectral::orthogonal_scale(p, q) * values[q];
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
  const Vector x = as_vector(map.coefs_x()), y = as_vector(map.coefs_y());
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

std::optional<CondensedElement> harmonic_element(const spectral::TriMap& map, int order) {
  const HarmonicFrame frame(map);
  if (order < 3 || !(frame.slenderness() <= harmonic_limits.most_slender) || std::abs(frame.b) >= 1) return {};
  const EdgePoints points = edge_points(map, frame, order);
  if (!(points.z.abs().maxCoeff() <= harmonic_limits.largest_radius)) return {};
  const EdgeValues at = edge_values(points, frame.b, harmonic_degree(order));
  const Products products = products_with_modes(at, edge_rule(order, !map.is_affine()), order);

  const Eigen::Index num = at.values.cols(), nb = products.flux.cols();
  Eigen::MatrixXd gram(num, num);
  gram.triangularView<Eigen::Lower>() = at.values.transpose() * at.fluxes;
  const Eigen::ArrayXd energies = gram.diagonal();
  if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(gram).info() != Eigen::Success) return {};
  if (!((gram.diagonal().array().square() / energies).minCoeff() > harmonic_limits.least_pivot)) return {};

  CondensedElement element;
  Eigen::MatrixXd half(num + nb, nb);  // S = half^T half
  half.topRows(num) = gram.triangularView<Eigen::Lower>().solve(products.flux);
  element.projection = gram.transpose().triangularView<Eigen::Upper>().solve(half.topRows(num));
  auto rest = half.bottomRows(nb);
  rest.setIdentity();
  rest.noalias() -= products.trace * element.projection;
  rest.topRows(3).rowwise() -= rest.topRows(3).colwise().mean().eval();  // constants have no energy
  rest = equilateral(order).root_diagonal.asDiagonal() * rest;
  Eigen::MatrixXd schur = Eigen::MatrixXd::Zero(nb, nb);
  schur.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
  element.schur = SymmetricMatrix(schur);
  return element;
}

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
