#include "chart/isothermal.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "chart/element_forms.hpp"
#include "chart/surface_poisson.hpp"

namespace quadrille::chart {
namespace {

constexpr int most_newton_steps = 30;
constexpr double closed_hole = 1e-13;  // of its length

/// Column 0 of scale and turn: without translations at the holes. Columns 2 j - 1 and 2 j: of the normal derivatives
/// cos and sin at hole j.
class IsothermalSolver {
 public:
  IsothermalSolver(SurfaceMesh& mesh, const std::vector<int>& loop_offsets)
      : mesh_(&mesh),
        num_outline_curves_(loop_offsets[1]),
        num_holes_(static_cast<int>(loop_offsets.size()) - 2),
        tables_(&element_tables(mesh.order)),
        forms_(surface_forms(mesh, loop_offsets)),
        poisson_(mesh, forms_) {}

  IsothermalFit solve() {
    scale_ = poisson_.solve_dirichlet(scale_loads(), num_outline_curves_);
    turn_ = poisson_.solve_neumann(turn_loads());
    combine(hole_amplitudes());
    const ElementColumns positions = poisson_.solve_neumann(position_loads());
    set_image(positions);
    return fit(positions);
  }

 private:
  ElementColumns scale_loads() const;
  ElementColumns turn_loads() const;
  ElementColumns position_loads() const;
  Eigen::VectorXd hole_amplitudes() const;
  void combine(const Eigen::VectorXd& amplitudes);
  OneForm differential(int elem) const;
  void set_image(const ElementColumns& positions);
  IsothermalFit fit(const ElementColumns& positions) const;

  SurfaceMesh* mesh_;
  int num_outline_curves_, num_holes_;
  const ElementTables* tables_;
  SurfaceForms forms_;
  SurfacePoisson poisson_;
  ElementColumns scale_, turn_;  ///< s, beta
};

// -int dq ^ omega, and at hole j int q (omega(t) + d_n s): the first part of d_n s makes the frame turn by nothing.
ElementColumns IsothermalSolver::scale_loads() const {
  ElementColumns loads;
  for (const ElementForms& elem : forms_.elems) {
    Eigen::MatrixXd load = Eigen::MatrixXd::Zero(tables_->from_modes.cols(), 1 + 2 * num_holes_);
    load.col(0) = wedges_with_gradients(*tables_, elem.omega);
    loads.push_back(std::move(load));
  }
  std::vector<double> turns(num_holes_ + 1, 0);
  for (const EdgeForms& edge : forms_.hole_edges) turns[edge.hole] += edge.omega.sum();
  for (const EdgeForms& edge : forms_.hole_edges) {
    const double flux = -turns[edge.hole] / forms_.hole_lengths[edge.hole];
    const Eigen::MatrixXd modes = tables_->edges[edge.edge].from_modes.transpose();
    Eigen::MatrixXd& load = loads[edge.elem];
    load.col(0) += modes * (edge.omega + flux * edge.length);
    load.col(2 * edge.hole - 1) += modes * edge.length.cwiseProduct(edge.turn.array().cos().matrix());
    load.col(2 * edge.hole) += modes * edge.length.cwiseProduct(edge.turn.array().sin().matrix());
  }
  return loads;
}

// -int <omega + *ds, dq>, with <*ds, dq> dA = ds ^ ... = -dq ^ ds.
ElementColumns IsothermalSolver::turn_loads() const {
  ElementColumns loads;
  for (std::size_t e = 0; e < forms_.elems.size(); ++e) {
    const OneForm ds{tables_->modes_xi1 * scale_[e], tables_->modes_xi2 * scale_[e]};
    Eigen::MatrixXd load = -wedges_with_gradients(*tables_, ds);
    load.col(0) -= products_with_gradients(*tables_, forms_.elems[e], forms_.elems[e].omega);
    loads.push_back(std::move(load));
  }
  return loads;
}

// e^(s - i beta) (theta1 + i theta2): columns of the real and the imaginary part.
OneForm IsothermalSolver::differential(int elem) const {
  const Eigen::ArrayXd s = tables_->from_modes * scale_[elem], beta = tables_->from_modes * turn_[elem];
  const Eigen::ArrayXd c = s.exp() * beta.cos(), d = s.exp() * beta.sin();
  const ElementForms& forms = forms_.elems[elem];
  const auto turned = [&](const Eigen::MatrixXd& theta1, const Eigen::MatrixXd& theta2) {
    Eigen::MatrixXd form(c.size(), 2);
    form.col(0) = c * theta1.array() + d * theta2.array();
    form.col(1) = c * theta2.array() - d * theta1.array();
    return form;
  };
  return {turned(forms.theta1.xi1, forms.theta2.xi1), turned(forms.theta1.xi2, forms.theta2.xi2)};
}

ElementColumns IsothermalSolver::position_loads() const {
  ElementColumns loads;
  for (std::size_t e = 0; e < forms_.elems.size(); ++e)
    loads.push_back(products_with_gradients(*tables_, forms_.elems[e], differential(static_cast<int>(e))));
  return loads;
}

// Newton's method for the translations of the image around the holes, sum over edges of e^(s - i beta) (theta1 + i
// theta2), which shall vanish.
Eigen::VectorXd IsothermalSolver::hole_amplitudes() const {
  const int n = 2 * num_holes_;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  for (int step = 0; n > 0 && step < most_newton_steps; ++step) {
    Eigen::VectorXd gap = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(n, n);
    double most = 0;
    for (const EdgeForms& edge : forms_.hole_edges) {
      const Eigen::MatrixXd& values = tables_->edges[edge.edge].from_modes;
      const Eigen::MatrixXd s = values * scale_[edge.elem], beta = values * turn_[edge.elem];
      const int row = 2 * (edge.hole - 1);
      for (Eigen::Index q = 0; q < s.rows(); ++q) {
        const std::complex<double> exponent(s(q, 0) + s.row(q).tail(n).dot(x),
                                            -beta(q, 0) - beta.row(q).tail(n).dot(x));
        const std::complex<double> step_q = std::exp(exponent) * std::complex(edge.theta1[q], edge.theta2[q]);
        gap[row] += step_q.real(), gap[row + 1] += step_q.imag();
        for (int k = 0; k < n; ++k) {
          const std::complex<double> slope = step_q * std::complex(s(q, k + 1), -beta(q, k + 1));
          slopes(row, k) += slope.real(), slopes(row + 1, k) += slope.imag();
        }
      }
    }
    for (int j = 0; j < num_holes_; ++j)
      most = std::max(most, gap.segment(2 * j, 2).norm() / forms_.hole_lengths[j + 1]);
    x -= slopes.partialPivLu().solve(gap);
    if (most < closed_hole) break;
  }
  return x;
}

void IsothermalSolver::combine(const Eigen::VectorXd& amplitudes) {
  for (ElementColumns* columns : {&scale_, &turn_})
    for (Eigen::MatrixXd& modes : *columns)
      modes = (modes.col(0) + modes.rightCols(amplitudes.size()) * amplitudes).eval();
}

void IsothermalSolver::set_image(const ElementColumns& positions) {
  mesh_->image.clear(), mesh_->scale.clear();
  for (std::size_t e = 0; e < positions.size(); ++e) {
    const Eigen::MatrixXd x = tables_->nodes_from_modes * positions[e];
    const Eigen::VectorXd s = tables_->nodes_from_modes * scale_[e];
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      mesh_->image.push_back({x(i, 0), x(i, 1)}), mesh_->scale.push_back(s[i]);
  }
}

IsothermalFit IsothermalSolver::fit(const ElementColumns& positions) const {
  IsothermalFit fit;
  double whole = 0, sum = 0;
  for (std::size_t e = 0; e < positions.size(); ++e) {
    const OneForm form = differential(static_cast<int>(e));
    whole += square(forms_.elems[e], form);
    fit.elem_squares.push_back(square(
        forms_.elems[e], {tables_->modes_xi1 * positions[e] - form.xi1, tables_->modes_xi2 * positions[e] - form.xi2}));
    sum += fit.elem_squares.back();
  }
  for (double& part : fit.elem_squares) part /= whole;
  fit.closedness = std::sqrt(sum / whole);
  return fit;
}

}  // namespace

IsothermalFit make_isothermal(SurfaceMesh& mesh, const std::vector<int>& loop_offsets) {
  return IsothermalSolver(mesh, loop_offsets).solve();
}

}  // namespace quadrille::chart
