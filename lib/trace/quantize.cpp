#include "trace/quantize.hpp"

#include <algorithm>
#include <cmath>

#include "trace/integer_programme.hpp"

namespace quadrille {
namespace {

using Term = IntegerProgramme::Term;

constexpr double longest = 1e4;  // length of one arc
constexpr int most_pieces = 60;  // of a cost function

void add_face_equations(const std::vector<TFace>& faces, IntegerProgramme& programme) {
  for (const TFace& face : faces)
    for (const int k : {0, 1}) {
      std::vector<Term> terms;
      for (const int dart : face[k]) terms.push_back({dart_arc(dart), 1});
      for (const int dart : face[k + 2]) terms.push_back({dart_arc(dart), -1});
      programme.add_equation(terms, 0);
    }
}

// n = 1 + y_2 + y_3 + ..., 0 <= y_k <= 1, where y_k costs what the step from k - 1 to k does.
void add_deviation(IntegerProgramme& programme, int variable, double target) {
  std::vector<Term> terms{{variable, 1}};
  const int last = std::clamp(static_cast<int>(std::ceil(2 * target)) + 4, 4, most_pieces);
  for (int k = 2; k <= last; ++k) {
    const double cost = (2 * k - 1 - 2 * target) / std::max(target, 0.5);
    terms.push_back({programme.add_variable(0, k < last ? 1 : longest, cost, false), -1});
  }
  programme.add_equation(terms, 1);
}

}  // namespace

std::vector<int> quantize(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit) {
  const int num_arcs = static_cast<int>(arc_lengths.size());
  IntegerProgramme programme;
  for (int a = 0; a < num_arcs; ++a) programme.add_variable(1, longest, 0, true);
  add_face_equations(faces, programme);
  for (int a = 0; a < num_arcs; ++a) add_deviation(programme, a, arc_lengths[a] / unit);
  std::vector<int> lengths;
  const std::vector<double> solution = programme.solve();
  if (!solution.empty())
    for (int a = 0; a < num_arcs; ++a) lengths.push_back(static_cast<int>(std::lround(solution[a])));
  return lengths;
}

// The equations are homogeneous: where an arc can be positive it can be 1 or more, together with all others that can.
std::vector<int> vanishing_arcs(const std::vector<TFace>& faces, int num_arcs) {
  IntegerProgramme programme;
  for (int a = 0; a < num_arcs; ++a) programme.add_variable(0, longest, 0, false);
  add_face_equations(faces, programme);
  std::vector<int> share;  // min(length, 1)
  for (int a = 0; a < num_arcs; ++a) {
    share.push_back(programme.add_variable(0, 1, -1, false));
    const int rest = programme.add_variable(0, longest, 0, false);
    programme.add_equation({{a, 1}, {share.back(), -1}, {rest, -1}}, 0);
  }
  const std::vector<double> solution = programme.solve();
  std::vector<int> zero;
  for (int a = 0; a < num_arcs; ++a)
    if (solution.empty() || solution[share[a]] < 0.5) zero.push_back(a);
  return zero;
}

}  // namespace quadrille
