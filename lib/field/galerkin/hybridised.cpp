#include "galerkin/hybridised.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "curve/chain.hpp"
#include "galerkin/condensed_system.hpp"
#include "galerkin/sparse_solver.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "spectral/quadrature.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::galerkin {
namespace {

// The modified basis along the three edges, at Gauss points.
struct EdgeTable {
  spectral::Quadrature rule;
  std::array<Eigen::MatrixXd, 3> values, d1, d2;  // modes x points
};

EdgeTable make_edge_table(int order, int num_points) {
  EdgeTable table;
  table.rule = spectral::gauss_legendre(num_points);
  const int n = spectral::num_tri_modes(order);
  for (int k = 0; k < 3; ++k) {
    for (auto* matrix : {&table.values[k], &table.d1[k], &table.d2[k]}) matrix->resize(n, num_points);
    for (int q = 0; q < num_points; ++q) {
      const Vec2 xi = spectral::tri_edge_point(k, (1 + table.rule.points[q]) / 2);
      spectral::modified_gradients(order, xi, table.values[k].col(q).data(), table.d1[k].col(q).data(),
                                   table.d2[k].col(q).data());
    }
  }
  return table;
}

const EdgeTable& edge_table(int order, int num_points) {
  static spectral::PerOrder<EdgeTable> tables([](int key) { return make_edge_table(key / 1000, key % 1000); });
  return tables[1000 * order + num_points];
}

// The terms of the form along one edge. Columns are Gauss points; the quadrature weights are kept separately.
struct EdgeTerms {
  Eigen::MatrixXd flux;              ///< d_n phi ds, without weight
  Eigen::MatrixXd values;            ///< phi
  Eigen::MatrixXd trace;             ///< trace modes
  Eigen::VectorXd weights, lengths;  ///< of the rule; |dx/ds| at its points
};

EdgeTerms edge_terms(const spectral::TriMap& map, int order, int edge, int edge_order, int num_points) {
  const EdgeTable& table = edge_table(order, num_points);
  const Vec2 along = (spectral::tri_edge_point(edge, 1) - spectral::tri_edge_point(edge, 0)) / 2;  // d xi / d s
  EdgeTerms terms;
  terms.values = table.values[edge];
  terms.flux.resize(terms.values.rows(), num_points);
  terms.trace.resize(num_trace_modes(edge_order), num_points);
  terms.weights.resize(num_points);
  terms.lengths.resize(num_points);
  for (int q = 0; q < num_points; ++q) {
    const double s = table.rule.points[q];
    Vec2 x;
    Mat2 j;
    map.evaluate(spectral::tri_edge_point(edge, (1 + s) / 2), x, j);
    const Vec2 tangent = j * along;
    // n ds = (t_y, -t_x) ds and grad phi = J^-T grad_xi phi, so the flux is grad_xi phi . J^-1 (t_y, -t_x).
    const Vec2 direction = inverse(j) * Vec2{tangent.y, -tangent.x};
    terms.flux.col(q) = direction.x * table.d1[edge].col(q) + direction.y * table.d2[edge].col(q);
    terms.lengths[q] = norm(tangent);
    terms.weights[q] = table.rule.weights[q];
    trace_values(edge_order, s, terms.trace.col(q).data());
  }
  return terms;
}

double area(const spectral::TriMap& map) {
  if (map.is_affine()) {
    Vec2 x;
    Mat2 jacobian;
    map.evaluate({0, 0}, x, jacobian);
    return 2 * det(jacobian);
  }
  const int num_points = map.order();  // det J has degree 2 N - 2
  const spectral::Quadrature along = spectral::gauss_legendre(num_points),
                             up = spectral::gauss_jacobi(num_points, 1, 0);
  double sum = 0;
  for (int i = 0; i < num_points; ++i) {
    for (int j = 0; j < num_points; ++j) {
      Vec2 x;
      Mat2 jacobian;
      map.evaluate({(1 + along.points[i]) * (1 - up.points[j]) / 2 - 1, up.points[j]}, x, jacobian);
      sum += along.weights[i] * up.weights[j] / 2 * det(jacobian);
    }
  }
  return sum;
}

// Legendre coefficients, degrees 0..order, of the data along one boundary edge, in the direction of its element.
Eigen::MatrixX2d project(const BoundaryEdge& edge, int order, const curve::ArcLength& arc_length,
                         const BoundaryData& data) {
  static spectral::PerOrder<spectral::Quadrature> rules(
      [](int n) { return spectral::gauss_legendre(n + 10); });  // the data are not polynomial
  const spectral::Quadrature& rule = rules[order];
  const double begin = arc_length.at(edge.t0), length = arc_length.at(edge.t1) - begin;
  Eigen::MatrixX2d coefs = Eigen::MatrixX2d::Zero(num_trace_modes(order), 2);
  Eigen::VectorXd modes(num_trace_modes(order));
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const Vec2 value = data(edge.curve, arc_length.parameter(begin + (1 + rule.points[q]) / 2 * length));
    trace_values(order, rule.points[q], modes.data());
    coefs += rule.weights[q] * modes * Eigen::RowVector2d(value.x, value.y);
  }
  return coefs;
}

}  // namespace

void trace_values(int order, double s, double* values) {
  double previous = 0, current = 1;  // P_{d-1}, P_d
  for (int d = 0; d <= order; ++d) {
    values[d] = std::sqrt((2 * d + 1) / 2.0) * current;
    const double next = ((2 * d + 1) * s * current - d * previous) / (d + 1);
    previous = std::exchange(current, next);
  }
}

stiffness::CondensedElement condense_to_trace(const spectral::TriMap& map, int order,
                                              const std::array<int, 3>& edge_orders, const Eigen::MatrixXd& stiffness,
                                              double penalty) {
  const int highest = std::max({order, edge_orders[0], edge_orders[1], edge_orders[2]});
  const int num_points = highest + (map.is_affine() ? 1 : 1 + map.order());
  std::array<EdgeTerms, 3> edges;
  double circumference = 0;
  int num_trace = 0;
  for (int k = 0; k < 3; ++k) {
    edges[k] = edge_terms(map, order, k, edge_orders[k], num_points);
    circumference += edges[k].weights.dot(edges[k].lengths);
    num_trace += num_trace_modes(edge_orders[k]);
  }
  const double tau = penalty * order * (order + 1) / 2 * circumference / area(map);

  Eigen::MatrixXd inside = stiffness;
  Eigen::MatrixXd coupling(stiffness.rows(), num_trace);
  Eigen::MatrixXd on_trace = Eigen::MatrixXd::Zero(num_trace, num_trace);
  int first = 0;
  for (const EdgeTerms& e : edges) {
    const int m = static_cast<int>(e.trace.rows());
    const Eigen::VectorXd mass = tau * e.weights.cwiseProduct(e.lengths);
    // With half of the penalty in each of the two transposed factors, -N - N^T + tau M is one symmetric sum.
    const Eigen::MatrixXd half = e.values * mass.asDiagonal() / 2 - e.flux * e.weights.asDiagonal();
    const Eigen::MatrixXd product = half * e.values.transpose();
    inside += product + product.transpose();
    coupling.middleCols(first, m) =
        (e.flux * e.weights.asDiagonal() - e.values * mass.asDiagonal()) * e.trace.transpose();
    on_trace.block(first, first, m, m) = e.trace * mass.asDiagonal() * e.trace.transpose();
    first += m;
  }

  return stiffness::eliminate_interior(inside, coupling, on_trace,
                                       "an element's penalty form is not positive definite");
}

Eigen::MatrixXd trace_data(const TriMesh& mesh, const mesh::TriTopology& topology, const DofMap& map,
                           const BoundaryData& data) {
  std::vector<std::unique_ptr<curve::ArcLength>> arc_lengths(mesh.face.num_curves());
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(map.num_dofs - map.num_unknowns, 2);
  for (const BoundaryEdge& boundary_edge : mesh.boundary_edges) {
    auto& arc_length = arc_lengths[boundary_edge.curve];
    if (!arc_length) arc_length = std::make_unique<curve::ArcLength>(mesh.face.curves[boundary_edge.curve]);
    const auto& vertices = mesh.elem2vertices[boundary_edge.elem];
    const int edge = topology.elem2edges[boundary_edge.elem][boundary_edge.edge], order = map.edge2order[edge];
    Eigen::MatrixX2d coefs = project(boundary_edge, order, *arc_length, data);
    if (vertices[boundary_edge.edge] >
        vertices[(boundary_edge.edge + 1) % 3]) {  // the direction of the edge is opposite
      for (int d = 1; d <= order; d += 2) coefs.row(d) *= -1;
    }
    values.middleRows(map.edge2dof[edge] - map.num_unknowns, order + 1) = coefs;
  }
  return values;
}

HybridisedGalerkin::HybridisedGalerkin(const MeshContext& context, BoundaryData data, int num_threads, double penalty)
    : context_(&context),
      num_threads_(num_threads),
      data_(std::move(data)),
      penalty_(penalty),
      orders_(context.maps.size(), Orders{}),
      elements_(context.maps.size()) {}

void HybridisedGalerkin::update_elements(const std::vector<int>& elem_order, const DofMap& map) {
  const Progress::Part part(context_->progress, "elements", static_cast<int>(elem_order.size()));
  parallel_for(static_cast<int>(elem_order.size()), num_threads_, [&](int e) {
    part.advance();
    const auto& edges = context_->topology.elem2edges[e];
    const std::array<int, 3> edge_orders{map.edge2order[edges[0]], map.edge2order[edges[1]], map.edge2order[edges[2]]};
    const Orders orders{elem_order[e], edge_orders[0], edge_orders[1], edge_orders[2]};
    if (orders == orders_[e]) return;
    try {
      const spectral::TriMap& shape = context_->maps[e];
      elements_[e] = std::make_shared<stiffness::CondensedElement>(condense_to_trace(
          shape, elem_order[e], edge_orders, stiffness::stiffness_matrix(shape, elem_order[e]), penalty_));
    } catch (const ComputeError& error) {
      throw ComputeError(fmt::format("{}: {}", context_->describe(e), error.what()));
    }
    orders_[e] = orders;
  });
}

int HybridisedGalerkin::num_unknowns(const std::vector<int>& elem_order) const {
  return make_trace_map(*context_->mesh, context_->topology, context_->tree.elimination_order, elem_order).num_unknowns;
}

Solution HybridisedGalerkin::solve(const std::vector<int>& elem_order) {
  Stopwatch watch;
  const DofMap map = make_trace_map(*context_->mesh, context_->topology, context_->tree.elimination_order, elem_order);
  update_elements(elem_order, map);
  watch.lap("elements");
  const Eigen::MatrixXd given = trace_data(*context_->mesh, context_->topology, map, data_);
  const Eigen::MatrixXd rhs = right_hand_side(map, elements_, given);
  watch.lap("data");
  const std::unique_ptr<SparseSolver> solver = make_sparse_solver(context_->tree, map, num_threads_);
  watch.lap("structure");
  solver->factor(elements_, context_->progress);
  watch.lap("factorisation");
  Eigen::MatrixXd dofs(map.num_dofs, 2);
  dofs << solver->solve(rhs), given;
  watch.lap("substitution");

  Solution solution;
  solution.num_unknowns = map.num_unknowns;
  solution.residual = relative_residual(map, elements_, rhs, dofs);
  watch.lap("residual");
  solution.elem_coefs.resize(elements_.size());
  parallel_for(static_cast<int>(elements_.size()), num_threads_, [&](int e) {
    solution.elem_coefs[e] = spectral::modified_to_orthogonal(elem_order[e]).transpose() * *elements_[e]->interior *
                             element_dofs(map, e, dofs);
  });
  watch.lap("coefficients");
  solution.laps = watch.laps();
  return solution;
}

}  // namespace quadrille::galerkin
