#include "quantize/integer_program.hpp"

#include <Cbc_C_Interface.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <string>

#include "base/error.hpp"

namespace quadrille::quantize {
namespace {

constexpr int max_nodes = 2000;
constexpr double relative_gap = 1e-3;  // between the solution and its bound

// The solver's library, from the path of the build, else from the system's folders.
class CbcLibrary {
 public:
  struct Symbol {
    void* address;
    template <class Function>
    operator Function*() const {
      return reinterpret_cast<Function*>(address);
    }
  };

  Symbol symbol(const char* name) const {
    const Symbol found{dlsym(library_, name)};
    if (found.address == nullptr) throw Defect(fmt::format("the solver of integer programs lacks {}", name));
    return found;
  }

 private:
  static void* load() {
    const std::string path = QUADRILLE_CBC_LIBRARY;
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) library = dlopen(path.substr(path.rfind('/') + 1).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw Defect(fmt::format("the solver of integer programs cannot be loaded: {}", dlerror()));
    return library;
  }

  void* library_ = load();
};

struct ModelFunctions {
  const CbcLibrary& cbc;
  decltype(&Cbc_newModel) create = cbc.symbol("Cbc_newModel");
  decltype(&Cbc_deleteModel) destroy = cbc.symbol("Cbc_deleteModel");
  decltype(&Cbc_loadProblem) load_problem = cbc.symbol("Cbc_loadProblem");
  decltype(&Cbc_setInteger) set_integer = cbc.symbol("Cbc_setInteger");
};

struct SearchFunctions {
  const CbcLibrary& cbc;
  decltype(&Cbc_setLogLevel) set_log_level = cbc.symbol("Cbc_setLogLevel");
  decltype(&Cbc_setMaximumNodes) set_maximum_nodes = cbc.symbol("Cbc_setMaximumNodes");
  decltype(&Cbc_setAllowableFractionGap) set_allowable_fraction_gap = cbc.symbol("Cbc_setAllowableFractionGap");
  decltype(&Cbc_solve) solve = cbc.symbol("Cbc_solve");
  decltype(&Cbc_bestSolution) best_solution = cbc.symbol("Cbc_bestSolution");
  decltype(&Cbc_isProvenOptimal) is_proven_optimal = cbc.symbol("Cbc_isProvenOptimal");
  decltype(&Cbc_getColSolution) get_col_solution = cbc.symbol("Cbc_getColSolution");
};

// The solver, loaded on first use: few layouts need it, and it depends on ten libraries, whose start-up takes as long
// as tracing a small layout.
struct Cbc {
  static const Cbc& get() {
    static const Cbc cbc;
    return cbc;
  }

  CbcLibrary library;
  ModelFunctions model{library};
  SearchFunctions search{library};
  /// The solver has global variables: of two searches at a time one would wait for commands from standard input.
  mutable std::mutex in_use;
};

struct Deleter {
  void operator()(Cbc_Model* model) const { Cbc::get().model.destroy(model); }
};

using Model = std::unique_ptr<Cbc_Model, Deleter>;

// Column-wise sparse matrix.
struct Matrix {
  std::vector<int> starts{0}, rows;
  std::vector<double> values;
};

Matrix matrix_of(const std::vector<std::vector<IntegerProgram::Term>>& columns) {
  Matrix matrix;
  for (const std::vector<IntegerProgram::Term>& column : columns) {
    for (const IntegerProgram::Term& entry : column) {
      matrix.rows.push_back(entry.variable);
      matrix.values.push_back(entry.coefficient);
    }
    matrix.starts.push_back(static_cast<int>(matrix.rows.size()));
  }
  return matrix;
}

// The best solution found, or null.
const double* best_solution(const SearchFunctions& search, const Model& model) {
  search.set_log_level(model.get(), 0);
  search.set_maximum_nodes(model.get(), max_nodes);
  search.set_allowable_fraction_gap(model.get(), relative_gap);
  search.solve(model.get());
  const double* best = search.best_solution(model.get());
  if (best == nullptr && search.is_proven_optimal(model.get()) != 0) best = search.get_col_solution(model.get());
  return best;
}

}  // namespace

int IntegerProgram::add_variable(double low, double high, double cost, bool is_integer) {
  low_.push_back(low), high_.push_back(high), cost_.push_back(cost), is_integer_.push_back(is_integer);
  column_.emplace_back();
  return static_cast<int>(column_.size()) - 1;
}

void IntegerProgram::add_equation(const std::vector<Term>& terms, double right_side) {
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

std::vector<double> IntegerProgram::solve() const {
  const Cbc& cbc = Cbc::get();
  const std::lock_guard lock(cbc.in_use);
  const Model model(cbc.model.create());
  const Matrix matrix = matrix_of(column_);
  const int num = static_cast<int>(column_.size());
  cbc.model.load_problem(model.get(), num, static_cast<int>(right_side_.size()), matrix.starts.data(),
                         matrix.rows.data(), matrix.values.data(), low_.data(), high_.data(), cost_.data(),
                         right_side_.data(), right_side_.data());
  for (int i = 0; i < num; ++i)
    if (is_integer_[i]) cbc.model.set_integer(model.get(), i);
  const double* best = best_solution(cbc.search, model);
  if (best == nullptr) return {};
  std::vector<double> solution(best, best + num);
  for (int i = 0; i < num; ++i)
    if (is_integer_[i]) solution[i] = std::round(solution[i]);
  return solution;
}

}  // namespace quadrille::quantize
