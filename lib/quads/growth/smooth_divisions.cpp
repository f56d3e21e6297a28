#include "growth/smooth_divisions.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "growth/interval_pairs.hpp"
#include "growth/opposite_ends.hpp"
#include "model/interfaces.hpp"
#include "sizing/name_joints.hpp"

namespace quadrille::growth {
namespace {

constexpr double weight_shape = 0.02;
constexpr double weight_skew = 1;
constexpr int max_steps = 6;
/// An interval keeps at least this part of its length in one step.
constexpr double least_part = 0.4;
/// Steps that move no end by more than this part of its arc are the last.
constexpr double small_step = 1e-7;

/// Numbers of the ends that move; -1 for the others.
class Variables {
 public:
  Variables(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
    for (int arc = 0; arc < input.measured.num_arcs(); ++arc) {
      const std::vector<double>& ends = divisions[arc].ends;
      const std::vector<double> fixed = fixed_fractions(input, arc);
      const int count = divisions[arc].num_intervals();
      numbers_.emplace_back(ends.size(), -1);
      for (int k = input.num_layers(arc, 0) + 1; k < count - input.num_layers(arc, 1); ++k) {
        const auto is_here = [&](double f) { return std::abs(f - ends[k]) < same_fraction; };
        if (std::none_of(fixed.begin(), fixed.end(), is_here)) numbers_[arc][k] = size_++;
      }
    }
  }
  int operator()(int arc, int end) const { return numbers_[arc][end]; }
  int size() const { return size_; }

 private:
  std::vector<std::vector<int>> numbers_;
  int size_ = 0;
};

/// The normal equations of weighted linear residuals.
class NormalEquations {
 public:
  explicit NormalEquations(int size) : right_(Eigen::VectorXd::Zero(size)) {}

  struct Term {
    int variable;
    double slope;
  };
  void add(double weight, double residual, const std::vector<Term>& terms) {
    for (const Term& a : terms) {
      if (a.variable < 0) continue;
      right_[a.variable] -= weight * a.slope * residual;
      for (const Term& b : terms)
        if (b.variable >= 0) entries_.emplace_back(a.variable, b.variable, weight * a.slope * b.slope);
    }
  }
  Eigen::SparseMatrix<double> matrix() const {
    Eigen::SparseMatrix<double> matrix(right_.size(), right_.size());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }
  const Eigen::VectorXd& right() const { return right_; }

 private:
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
};

/// The terms of ln d of an interval, times `sign`.
void append_log(const sizing::ArcDivisions& divisions, const Variables& variables, const Interval& interval,
                double sign, std::vector<NormalEquations::Term>& terms) {
  const auto [arc, k] = interval;
  const double slope = sign / (divisions[arc].high(k) - divisions[arc].low(k));
  terms.push_back({variables(arc, k + 1), slope});
  terms.push_back({variables(arc, k), -slope});
}

void add_growth(const GrowthInput& input, const sizing::ArcDivisions& divisions, const Variables& variables,
                const Excess& excess, NormalEquations& equations) {
  const double limit = std::log(input.limit), aim = excess.aim * limit;
  for (const IntervalPair& pair : adjacent_intervals(input, divisions)) {
    std::vector<NormalEquations::Term> terms;
    append_log(divisions, variables, pair.b, 1, terms);
    append_log(divisions, variables, pair.a, -1, terms);
    const double r = log_growth(input, divisions, pair), part = r * r / (limit * limit);
    // The derivatives of r^2 + r^4 / (2 limit^2) by r are 2 r (1 + part) and 2 (1 + 3 part).
    equations.add(1 + 3 * part, r * (1 + part) / (1 + 3 * part), terms);
    if (excess.weight > 0 && std::abs(r) > aim)
      equations.add(excess.weight, std::copysign(std::abs(r) - aim, r), terms);
  }
}

void add_shape(const GrowthInput& input, const sizing::ArcDivisions& shape, const sizing::ArcDivisions& divisions,
               const Variables& variables, NormalEquations& equations) {
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
    for (int k = 0; k < divisions[arc].num_intervals(); ++k) {
      std::vector<NormalEquations::Term> terms;
      append_log(divisions, variables, {arc, k}, 1, terms);
      const double change = length_of(input, divisions, {arc, k}) / length_of(input, shape, {arc, k});
      equations.add(weight_shape, std::log(change), terms);
    }
}

void add_skew(const std::vector<OppositeSides>& opposite, const sizing::ArcDivisions& divisions,
              const Variables& variables, NormalEquations& equations) {
  for (const OppositeSides& pair : opposite)
    for (int i = 1; i < pair.a.count; ++i) {
      const RelativeEnd a = pair.a.at(divisions, i), b = pair.b.at(divisions, i);
      const double scale = pair.slenderness;
      equations.add(
          weight_skew, scale * (a.position - b.position),
          {{variables(pair.a.arc, a.end), scale * a.slope}, {variables(pair.b.arc, b.end), -scale * b.slope}});
    }
}

/// The greatest part of the step, at most 1, with which no interval is shortened too much.
double allowed_part(const sizing::ArcDivisions& divisions, const Variables& variables, const Eigen::VectorXd& step) {
  const auto move = [&](int arc, int end) { return variables(arc, end) < 0 ? 0 : step[variables(arc, end)]; };
  double part = 1;
  for (int arc = 0; arc < static_cast<int>(divisions.size()); ++arc)
    for (int k = 0; k < divisions[arc].num_intervals(); ++k) {
      const double loss = move(arc, k) - move(arc, k + 1), most = 1 - least_part;
      const double own = divisions[arc].high(k) - divisions[arc].low(k);
      if (loss * part > most * own) part = most * own / loss;
    }
  return part;
}

}  // namespace

std::vector<double> fixed_fractions(const GrowthInput& input, int arc) {
  const BlockLayout& blocks = input.measured.blocks();
  if (!is_on_cad_curve(blocks, blocks.arcs[arc])) return {};
  std::vector<double> fractions = input.measured.chain(arc).break_fractions();
  const std::vector<double> joints = sizing::name_joints(input.measured.chain(arc), blocks.face);
  fractions.insert(fractions.end(), joints.begin(), joints.end());
  return fractions;
}

struct DivisionSmoother::State {
  GrowthInput input;
  sizing::ArcDivisions shape;
  Variables variables;
  std::vector<OppositeSides> opposite;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  bool is_analysed = false;

  /// The step of Gauss and Newton. All steps have entries in the same places.
  Eigen::VectorXd step(const Excess& excess, const sizing::ArcDivisions& divisions) {
    NormalEquations equations(variables.size());
    add_growth(input, divisions, variables, excess, equations);
    add_shape(input, shape, divisions, variables, equations);
    add_skew(opposite, divisions, variables, equations);
    const Eigen::SparseMatrix<double> matrix = equations.matrix();
    if (!is_analysed) solver.analyzePattern(matrix);
    is_analysed = true;
    solver.factorize(matrix);
    return solver.solve(equations.right());
  }
};

DivisionSmoother::DivisionSmoother(const GrowthInput& input, const sizing::ArcDivisions& shape)
    : state_(new State{input, shape, Variables(input, shape), opposite_arcs(input, shape), {}, false}) {}

DivisionSmoother::~DivisionSmoother() = default;

void DivisionSmoother::smooth(const Excess& excess, sizing::ArcDivisions& divisions) {
  const Variables& variables = state_->variables;
  if (variables.size() == 0) return;
  for (int i = 0; i < max_steps; ++i) {
    const Eigen::VectorXd step = state_->step(excess, divisions);
    if (!step.allFinite()) return;  // intervals so different that the equations have no solution in these numbers
    const double part = allowed_part(divisions, variables, step);
    for (int arc = 0; arc < static_cast<int>(divisions.size()); ++arc)
      for (int end = 1; end < divisions[arc].num_intervals(); ++end)
        if (variables(arc, end) >= 0) divisions[arc].ends[end] += part * step[variables(arc, end)];
    if (part == 1 && step.cwiseAbs().maxCoeff() < small_step) return;
  }
}

}  // namespace quadrille::growth
