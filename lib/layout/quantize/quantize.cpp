#include "quantize/quantize.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "quantize/integer_program.hpp"
#include "quantize/length_flow.hpp"

namespace quadrille::quantize {
namespace {

using Term = IntegerProgram::Term;

constexpr double max_length = 1e4;  // of one arc
constexpr double relative_tie = 1e-6;
constexpr int max_pieces = 60;  // of a cost function
// The time that the integer program takes grows faster than the number of arcs.
constexpr int max_program_arcs = 2000;

void add_face_equations(const std::vector<TFace>& faces, IntegerProgram& program) {
  for (const TFace& face : faces)
    for (const int k : {0, 1}) {
      std::vector<Term> terms;
      for (const HalfEdge h : face[k]) terms.push_back({h.arc, 1});
      for (const HalfEdge h : face[k + 2]) terms.push_back({h.arc, -1});
      program.add_equation(terms, 0);
    }
}

// n = 1 + y_2 + y_3 + ..., 0 <= y_k <= 1, where y_k has the cost of the step from k - 1 to k.
void add_deviation(IntegerProgram& program, int variable, double target) {
  std::vector<Term> terms{{variable, 1}};
  const int last = std::clamp(static_cast<int>(std::ceil(2 * target)) + 4, 4, max_pieces);
  for (int k = 2; k <= last; ++k) {
    const double cost = (2 * k - 1 - 2 * target) / std::max(target, 0.5);
    terms.push_back({program.add_variable(0, k < last ? 1 : max_length, cost, false), -1});
  }
  program.add_equation(terms, 1);
}

// Arcs of one symmetry orbit have one length in the plane: they are assigned the same integer length.
void add_ties(const std::vector<double>& arc_lengths, IntegerProgram& program) {
  std::vector<int> by_length(arc_lengths.size());
  std::iota(by_length.begin(), by_length.end(), 0);
  std::stable_sort(by_length.begin(), by_length.end(), [&](int a, int b) { return arc_lengths[a] < arc_lengths[b]; });
  for (size_t k = 0; k + 1 < by_length.size(); ++k) {
    const int a = by_length[k], b = by_length[k + 1];
    if (arc_lengths[b] - arc_lengths[a] <= relative_tie * arc_lengths[b]) program.add_equation({{a, 1}, {b, -1}}, 0);
  }
}

std::vector<int> solve(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit,
                       bool ties) {
  const int num_arcs = static_cast<int>(arc_lengths.size());
  IntegerProgram program;
  for (int a = 0; a < num_arcs; ++a) program.add_variable(1, max_length, 0, true);
  add_face_equations(faces, program);
  if (ties) add_ties(arc_lengths, program);
  for (int a = 0; a < num_arcs; ++a) add_deviation(program, a, arc_lengths[a] / unit);
  std::vector<int> lengths;
  const std::vector<double> solution = program.solve();
  if (!solution.empty())
    for (int a = 0; a < num_arcs; ++a) lengths.push_back(static_cast<int>(std::lround(solution[a])));
  return lengths;
}

}  // namespace

std::vector<int> quantize(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit) {
  std::vector<int> lengths = solve(faces, arc_lengths, unit, true);
  return lengths.empty() ? solve(faces, arc_lengths, unit, false) : lengths;
}

Quantization quantize_or_explain(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit) {
  const int num_arcs = static_cast<int>(arc_lengths.size());
  if (num_arcs > max_program_arcs) {
    std::vector<double> targets;
    for (const double length : arc_lengths) targets.push_back(length / unit);
    FlowLengths found = flow_lengths(faces, targets);
    return {std::move(found.lengths), std::move(found.strips)};
  }
  Quantization result{quantize(faces, arc_lengths, unit), {}};
  if (!result.lengths.empty()) return result;
  if (const std::vector<int> zero_arcs = forced_zero_arcs(faces, num_arcs); !zero_arcs.empty())
    result.strips.push_back(infeasibility_certificate(faces, num_arcs, zero_arcs.front()));
  return result;
}

// The equations are homogeneous: all arcs that can be positive can be 1 or more at once.
std::vector<int> forced_zero_arcs(const std::vector<TFace>& faces, int num_arcs) {
  IntegerProgram program;
  for (int a = 0; a < num_arcs; ++a) program.add_variable(0, max_length, 0, false);
  add_face_equations(faces, program);
  std::vector<int> positive;  // variables min(length, 1)
  for (int a = 0; a < num_arcs; ++a) {
    positive.push_back(program.add_variable(0, 1, -1, false));
    const int rest = program.add_variable(0, max_length, 0, false);
    program.add_equation({{a, 1}, {positive.back(), -1}, {rest, -1}}, 0);
  }
  const std::vector<double> solution = program.solve();
  std::vector<int> zero;
  for (int a = 0; a < num_arcs; ++a)
    if (solution.empty() || solution[positive[a]] < 0.5) zero.push_back(a);
  return zero;
}

std::vector<int> infeasibility_certificate(const std::vector<TFace>& faces, int num_arcs, int zero_arc) {
  IntegerProgram program;
  std::vector<std::vector<Term>> column(num_arcs);  // of the equations' matrix
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    for (const int k : {0, 1}) {
      const int plus = program.add_variable(0, max_length, 1, false);
      const int minus = program.add_variable(0, max_length, 1, false);
      for (const int side : {k, k + 2})
        for (const HalfEdge h : faces[f][side]) {
          const double sign = side == k ? 1 : -1;
          column[h.arc].push_back({plus, sign});
          column[h.arc].push_back({minus, -sign});
        }
    }
  for (int a = 0; a < num_arcs; ++a) {
    column[a].push_back({program.add_variable(0, max_length, 0, false), -1});
    program.add_equation(column[a], a == zero_arc ? 1 : 0);
  }
  const std::vector<double> solution = program.solve();
  std::set<int> along;  // arcs along the strip
  if (solution.empty()) return {};
  for (size_t e = 0; e < 2 * faces.size(); ++e) {
    if (solution[2 * e] + solution[2 * e + 1] < 1e-6) continue;
    for (const size_t side : {e % 2 + 1, (e % 2 + 3) % 4})
      for (const HalfEdge h : faces[e / 2][side]) along.insert(h.arc);
  }
  return {along.begin(), along.end()};
}

}  // namespace quadrille::quantize
