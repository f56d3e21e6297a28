#include "trace/integer_programme.hpp"

#include <Cbc_C_Interface.h>

#include <cmath>
#include <memory>

namespace quadrille {
namespace {

constexpr int max_nodes = 2000;
constexpr double gap_share = 1e-3;  // a solution this near to the bound is good enough

struct Deleter {
  void operator()(Cbc_Model* model) const { Cbc_deleteModel(model); }
};

}  // namespace

int IntegerProgramme::add_variable(double low, double high, double cost, bool is_integer) {
  low_.push_back(low), high_.push_back(high), cost_.push_back(cost), is_integer_.push_back(is_integer);
  column_.emplace_back();
  return static_cast<int>(column_.size()) - 1;
}

void IntegerProgramme::add_equation(const std::vector<Term>& terms, double right_side) {
  const int row = static_cast<int>(right_side_.size());
  for (const Term& term : terms) {
    std::vector<Term>& column = column_[term.variable];
    if (!column.empty() && column.back().variable == row)
      column.back().coefficient += term.coefficient;
    else
      column.push_back({row, term.coefficient});
  }
  right_side_.push_back(right_side);
}

std::vector<double> IntegerProgramme::solve() const {
  std::vector<int> starts{0}, rows;
  std::vector<double> values;
  for (const std::vector<Term>& column : column_) {
    for (const Term& entry : column) rows.push_back(entry.variable), values.push_back(entry.coefficient);
    starts.push_back(static_cast<int>(rows.size()));
  }
  const std::unique_ptr<Cbc_Model, Deleter> model(Cbc_newModel());
  const int num = static_cast<int>(column_.size());
  Cbc_loadProblem(model.get(), num, static_cast<int>(right_side_.size()), starts.data(), rows.data(), values.data(),
                  low_.data(), high_.data(), cost_.data(), right_side_.data(), right_side_.data());
  for (int i = 0; i < num; ++i)
    if (is_integer_[i]) Cbc_setInteger(model.get(), i);
  Cbc_setLogLevel(model.get(), 0);
  Cbc_setMaximumNodes(model.get(), max_nodes);
  Cbc_setAllowableFractionGap(model.get(), gap_share);
  Cbc_solve(model.get());
  const double* best = Cbc_bestSolution(model.get());
  if (best == nullptr && Cbc_isProvenOptimal(model.get()) != 0) best = Cbc_getColSolution(model.get());
  if (best == nullptr) return {};
  std::vector<double> solution(best, best + num);
  for (int i = 0; i < num; ++i)
    if (is_integer_[i]) solution[i] = std::round(solution[i]);
  return solution;
}

}  // namespace quadrille
