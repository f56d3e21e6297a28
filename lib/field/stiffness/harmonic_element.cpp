#include "stiffness/harmonic_element.hpp"

#include <complex>
#include <utility>

#include "spectral/modified_basis.hpp"
#include "stiffness/edge_rules.hpp"
#include "stiffness/equilateral.hpp"
#include "stiffness/harmonic_frame.hpp"

namespace quadrille::stiffness {
namespace {

constexpr double most_slender = 3;      // beyond that the substitute D is too far off
constexpr double least_pivot = 1e-8;    // part of a polynomial's energy that those of lower degree do not represent
constexpr double largest_radius = 2.5;  // |z| in a curved element; at the vertices of an equilateral one it is 1.37

// Re p_1, Im p_1, Re p_2, ... at the points of the edges, and their normal derivatives times the weights.
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
  return products;
}

void set_vertex_traces(const spectral::TriMap& map, const HarmonicFrame& frame, Eigen::MatrixXd& trace) {
  for (int k = 0; k < 3; ++k) {
    const std::complex<double> z = frame(map.position(spectral::tri_edge_point(k, 0)));
    std::complex<double> p = 1, p1 = 0, p2 = 0;
    for (Eigen::Index re = 0; re < trace.cols(); re += 2) {
      p2 = std::exchange(p1, std::exchange(p, next_polynomial(z, frame.b, p, p1, p2)));
      trace(k, re) = p.real();
      trace(k, re + 1) = p.imag();
    }
  }
}

}  // namespace

std::optional<HarmonicElement> harmonic_element(const spectral::TriMap& map, int order) {
  const HarmonicFrame frame(map);
  if (order < 3 || !(frame.slenderness() <= most_slender) || std::abs(frame.b) >= 1) return {};
  const EdgePoints points = edge_points(map, frame, order);
  if (!(points.z.abs().maxCoeff() <= largest_radius)) return {};
  const EdgeValues at = edge_values(points, frame.b, harmonic_degree(order));
  Products products = products_with_modes(at, edge_rule(order, !map.is_affine()), order);
  set_vertex_traces(map, frame, products.trace);

  const Eigen::Index num = at.values.cols(), nb = products.flux.cols();
  Eigen::MatrixXd gram(num, num);
  gram.triangularView<Eigen::Lower>() = at.values.transpose() * at.fluxes;
  const Eigen::ArrayXd energies = gram.diagonal();
  if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(gram).info() != Eigen::Success) return {};
  if (!((gram.diagonal().array().square() / energies).minCoeff() > least_pivot)) return {};

  HarmonicElement element;
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

}  // namespace quadrille::stiffness
