#include "growth/smooth_divisions.hpp"

#include <algorithm>
#include <cmath>

#include "growth/normal_equations.hpp"
#include "mesh/chords.hpp"
#include "model/interfaces.hpp"

namespace quadrille::growth {
namespace {

struct SmoothConstants {
  double shape_weight = 0.02;
  double skew_weight = 1;
  int max_steps = 6;
  double least_part = 0.4;        ///< of its length that an interval keeps in one step
  double small_step = 1e-7;       ///< steps that move no end by more than this part of its arc are the last
  double derivative_step = 1e-5;  ///< of a fraction
};
constexpr SmoothConstants smooth_constants;

using Term = NormalEquations::Term;

double length_of(const GrowthInput& input, const sizing::ArcDivisions& divisions, const Interval& interval) {
  return divisions[interval.arc].width(interval.k) * input.measured.length(interval.arc);
}

/// An end of an interval and its position along the side: 0 and 1 where the layers of both sides end, if they have
/// equally many, else at the nodes.
struct RelativeEnd {
  int end = 0;          ///< its number on the arc
  double position = 0;  ///< by the chord's parameter
  double slope = 0;     ///< of the position by the arc's own fraction
};

/// A side of a block, in the direction of its opposite side.
struct AlignedSide {
  const sizing::ArcParameter* parameter = nullptr;
  int arc = 0, count = 0;
  bool is_reversed = false;
  std::array<int, 2> layers{};  ///< at the beginning and the end of the side
  double low = 0, high = 1;     ///< chord's parameters of the positions 0 and 1

  AlignedSide(const GrowthInput& input, const sizing::ArcDivisions& divisions, int of_arc, bool reversed)
      : parameter(&input.measured.parameter(of_arc)),
        arc(of_arc),
        count(divisions[of_arc].num_intervals()),
        is_reversed(reversed),
        layers{input.num_layers(of_arc, reversed ? 1 : 0), input.num_layers(of_arc, reversed ? 0 : 1)} {}

  RelativeEnd at(const sizing::ArcDivisions& divisions, int i) const {
    const int end = is_reversed ? count - i : i;
    const double fraction = divisions[arc].ends[end], u = parameter->parameter(fraction), range = high - low;
    const double slope = slope_at(fraction) / range;
    return {end, ((is_reversed ? 1 - u : u) - low) / range, is_reversed ? -slope : slope};
  }

  /// Positions count from the ends of the layers.
  void skip_layers(const sizing::ArcDivisions& divisions) {
    const double first = at(divisions, layers[0]).position;
    high = at(divisions, count - layers[1]).position;
    low = first;
  }

 private:
  double slope_at(double fraction) const {
    if (parameter->is_identity()) return 1;
    const double before = std::max(0.0, fraction - smooth_constants.derivative_step);
    const double after = std::min(1.0, fraction + smooth_constants.derivative_step);
    return (parameter->parameter(after) - parameter->parameter(before)) / (after - before);
  }
};

struct OppositeSides {
  AlignedSide a, b;
  double slenderness = 0;  ///< mean length of both over their distance
};

/// Both pairs of sides of every block; a block that touches itself has none.
std::vector<OppositeSides> opposite_sides(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  const BlockLayout& blocks = input.measured.blocks();
  std::vector<OppositeSides> pairs;
  for (int block = 0; block < blocks.num_blocks(); ++block)
    for (const int k : {0, 1}) {
      const auto half = [&](int side) { return mesh::half_edge(blocks, block, side); };
      const auto length = [&](int side) { return input.measured.length(half(side).arc); };
      if (half(k).arc == half(k + 2).arc) continue;
      OppositeSides pair{{input, divisions, half(k).arc, half(k).is_backwards},
                         {input, divisions, half(k + 2).arc, !half(k + 2).is_backwards},
                         (length(k) + length(k + 2)) / (length(k + 1) + length(k + 3))};
      if (pair.a.layers == pair.b.layers) pair.a.skip_layers(divisions), pair.b.skip_layers(divisions);
      pairs.push_back(pair);
    }
  return pairs;
}

/// Numbers of the ends that move; -1 for the others.
class Variables {
 public:
  Variables(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
    for (int arc = 0; arc < input.measured.num_arcs(); ++arc) {
      const std::vector<double>& ends = divisions[arc].ends;
      const std::vector<double> fixed = fixed_fractions(input, arc);
      const int count = divisions[arc].num_intervals();
      numbers_.emplace_back(ends.size(), -1);
      for (int k = input.num_layers(arc, 0) + 1; k < count - input.num_layers(arc, 1); ++k)
        if (!sizing::has_fraction(fixed, ends[k])) numbers_[arc][k] = size_++;
    }
  }
  int operator()(int arc, int end) const { return numbers_[arc][end]; }
  int size() const { return size_; }

 private:
  std::vector<std::vector<int>> numbers_;
  int size_ = 0;
};

}  // namespace

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
    add_growth(excess, divisions, equations);
    add_shape(divisions, equations);
    add_skew(divisions, equations);
    const Eigen::SparseMatrix<double> matrix = equations.matrix();
    if (!is_analysed) solver.analyzePattern(matrix);
    is_analysed = true;
    solver.factorize(matrix);
    return solver.solve(equations.right());
  }

  /// The greatest part of the step, at most 1, with which no interval is shortened too much.
  double allowed_part(const sizing::ArcDivisions& divisions, const Eigen::VectorXd& step) const {
    const auto move = [&](int arc, int end) { return variables(arc, end) < 0 ? 0 : step[variables(arc, end)]; };
    double part = 1;
    for (int arc = 0; arc < std::ssize(divisions); ++arc)
      for (int k = 0; k < divisions[arc].num_intervals(); ++k) {
        const double loss = move(arc, k) - move(arc, k + 1);
        const double most = (1 - smooth_constants.least_part) * divisions[arc].width(k);
        if (loss * part > most) part = most / loss;
      }
    return part;
  }

 private:
  /// The terms of ln d of an interval, times `sign`.
  std::array<Term, 2> log_terms(const sizing::ArcDivisions& divisions, const Interval& interval, double sign) const {
    const auto [arc, k] = interval;
    const double slope = sign / divisions[arc].width(k);
    return {{{variables(arc, k + 1), slope}, {variables(arc, k), -slope}}};
  }

  void add_growth(const Excess& excess, const sizing::ArcDivisions& divisions, NormalEquations& equations) const {
    const double limit = std::log(input.limit), aim = excess.aim * limit;
    for (const IntervalPair& pair : adjacent_intervals(input, divisions)) {
      const auto a = log_terms(divisions, pair.a, -1), b = log_terms(divisions, pair.b, 1);
      const double r = log_growth(input, divisions, pair), part = r * r / (limit * limit);
      // The derivatives of r^2 + r^4 / (2 limit^2) by r are 2 r (1 + part) and 2 (1 + 3 part).
      equations.add(1 + 3 * part, r * (1 + part) / (1 + 3 * part), {b[0], b[1], a[0], a[1]});
      if (excess.weight > 0 && std::abs(r) > aim)
        equations.add(excess.weight, std::copysign(std::abs(r) - aim, r), {b[0], b[1], a[0], a[1]});
    }
  }

  void add_shape(const sizing::ArcDivisions& divisions, NormalEquations& equations) const {
    for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
      for (int k = 0; k < divisions[arc].num_intervals(); ++k) {
        const auto [high, low] = log_terms(divisions, {arc, k}, 1);
        const double change = length_of(input, divisions, {arc, k}) / length_of(input, shape, {arc, k});
        equations.add(smooth_constants.shape_weight, std::log(change), {high, low});
      }
  }

  void add_skew(const sizing::ArcDivisions& divisions, NormalEquations& equations) const {
    for (const auto& [side_a, side_b, scale] : opposite)
      for (int i = 1; i < side_a.count; ++i) {
        const RelativeEnd a = side_a.at(divisions, i), b = side_b.at(divisions, i);
        equations.add(
            smooth_constants.skew_weight, scale * (a.position - b.position),
            {{variables(side_a.arc, a.end), scale * a.slope}, {variables(side_b.arc, b.end), -scale * b.slope}});
      }
  }
};

bool is_layer(const GrowthInput& input, const sizing::ArcDivisions& divisions, const Interval& interval) {
  return interval.k < input.num_layers(interval.arc, 0) ||
         interval.k >= divisions[interval.arc].num_intervals() - input.num_layers(interval.arc, 1);
}

std::vector<IntervalPair> adjacent_intervals(const GrowthInput& input, const sizing::ArcDivisions& divisions) {
  std::vector<IntervalPair> pairs;
  const auto add = [&](const Interval& a, const Interval& b) {
    if (!is_layer(input, divisions, a) || !is_layer(input, divisions, b)) pairs.push_back({a, b});
  };
  const auto at_end = [&](const mesh::ArcEnd& at) {
    return Interval{at.arc, at.end == 0 ? 0 : divisions[at.arc].num_intervals() - 1};
  };
  for (int arc = 0; arc < input.measured.num_arcs(); ++arc)
    for (int k = 0; k + 1 < divisions[arc].num_intervals(); ++k) add({arc, k}, {arc, k + 1});
  for (const auto& [a, b] : mesh::arc_neighbours(input.measured.blocks())) add(at_end(a), at_end(b));
  return pairs;
}

double log_growth(const GrowthInput& input, const sizing::ArcDivisions& divisions, const IntervalPair& pair) {
  return std::log(length_of(input, divisions, pair.b) / length_of(input, divisions, pair.a));
}

std::vector<double> fixed_fractions(const GrowthInput& input, int arc) {
  if (!input.measured.is_on_cad_curve(arc)) return {};
  std::vector<double> fractions = input.measured.chain(arc).break_fractions();
  const std::vector<double> joints = input.measured.name_joints(arc);
  fractions.insert(fractions.end(), joints.begin(), joints.end());
  return fractions;
}

DivisionSmoother::DivisionSmoother(const GrowthInput& input, const sizing::ArcDivisions& shape)
    : state_(new State{input, shape, Variables(input, shape), opposite_sides(input, shape), {}, false}) {}

DivisionSmoother::~DivisionSmoother() = default;

void DivisionSmoother::smooth(const Excess& excess, sizing::ArcDivisions& divisions) {
  const Variables& variables = state_->variables;
  if (variables.size() == 0) return;
  for (int i = 0; i < smooth_constants.max_steps; ++i) {
    const Eigen::VectorXd step = state_->step(excess, divisions);
    if (!step.allFinite()) return;  // intervals so different that the equations have no solution in these numbers
    const double part = state_->allowed_part(divisions, step);
    for (int arc = 0; arc < std::ssize(divisions); ++arc)
      for (int end = 1; end < divisions[arc].num_intervals(); ++end)
        if (variables(arc, end) >= 0) divisions[arc].ends[end] += part * step[variables(arc, end)];
    if (part == 1 && step.cwiseAbs().maxCoeff() < smooth_constants.small_step) return;
  }
}

}  // namespace quadrille::growth
