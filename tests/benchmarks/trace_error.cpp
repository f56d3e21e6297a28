// Cost against error of both integrators of separatrices on one field, for tests/benchmarks/tracing.
//
//   trace_error FIELD CRIT     writes one line of JSON
//
// All separatrices of CRIT, each up to where it ends or first comes within 2 % of the diameter of another node (from
// there on nearly head-on lines part for ever, whatever the integrator). Errors are distances to a reference at the
// same arc length and of the ends, in diameters: the greatest of all lines. The reference is the reference-space
// integrator with a tolerance of 1e-14. CPU seconds: all lines once, launches excluded, the least of several runs.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "adams_bashforth.hpp"
#include "check/check.hpp"
#include "field/evaluate.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"
#include "trace/launch.hpp"

using namespace quadrille;

namespace {

constexpr double node_margin = 0.02, max_step = 0.05, max_length = 4;  // diameters
constexpr double reference_tolerance = 1e-14;
constexpr int num_samples = 400;

using Integrator = std::function<trace::Streamline(const trace::Launch&, double length)>;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Comparison {
 public:
  Comparison(const field::FieldEvaluator& evaluator, const CriticalPoints& points)
      : evaluator_(evaluator),
        diameter_(evaluator.field().mesh.face.diameter),
        launches_(trace::launch_all(evaluator, points)) {
    for (const GraphNode& node : trace::fixed_nodes(evaluator.field().mesh.face, points))
      nodes_.push_back(node.position);
    const trace::AdvanceOptions bounds{reference_tolerance * diameter_, max_step * diameter_, max_length * diameter_,
                                       node_margin * diameter_};
    for (const trace::Launch& launch : launches_) {
      reference_.push_back(trace::advance(evaluator, launch, PointGrid(nodes_), bounds));
      lengths_.push_back(reference_.back().length());
    }
  }

  trace::Streamline runge_kutta(const trace::Launch& launch, double length, double tolerance) const {
    return trace::advance(evaluator_, launch, PointGrid(nodes_),
                          {tolerance * diameter_, max_step * diameter_, length, 0});
  }
  trace::Streamline adams_bashforth(const trace::Launch& launch, double length, double step) const {
    return trace::advance_adams_bashforth(evaluator_, launch, PointGrid(nodes_), {0, step * diameter_, length, 0});
  }

  std::string measure(const char* name, double value, const Integrator& integrator) const {
    double least = 1e300, spent = 0;
    std::vector<trace::Streamline> lines;
    for (int run = 0; run < 3 || (spent < 0.3 && run < 100); ++run) {
      lines.clear();
      const double begin = cpu_seconds();
      for (size_t i = 0; i < launches_.size(); ++i) lines.push_back(integrator(launches_[i], lengths_[i]));
      const double cpu = cpu_seconds() - begin;
      least = std::min(least, cpu), spent += cpu;
    }
    double error = 0;
    size_t steps = 0;
    for (size_t i = 0; i < lines.size(); ++i) {
      error = std::max(error, miss(lines[i], reference_[i], lengths_[i]));
      steps += lines[i].steps.size();
    }
    return fmt::format(R"({{"{}": {:.3g}, "steps": {}, "error": {:.3g}, "cpu_seconds": {:.3g}}})", name, value, steps,
                       error / diameter_, least);
  }

  size_t num_lines() const { return launches_.size(); }

 private:
  double miss(const trace::Streamline& line, const trace::Streamline& reference, double length) const {
    double error = 0;
    for (int i = 0; i < num_samples; ++i) {
      const double s = length * (i + 0.5) / num_samples;
      if (s > line.length() || s > reference.length()) break;
      error = std::max(error, distance(line.at(evaluator_, s), reference.at(evaluator_, s)));
    }
    if (reference.end != trace::Streamline::End::boundary) return error;
    return std::max(error, distance(line.end_position, reference.end_position));
  }

  const field::FieldEvaluator& evaluator_;
  double diameter_;
  std::vector<trace::Launch> launches_;
  std::vector<Vec2> nodes_;
  std::vector<trace::Streamline> reference_;
  std::vector<double> lengths_;
};

std::string join(const std::vector<std::string>& items) { return fmt::format("[{}]", fmt::join(items, ", ")); }

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: trace_error FIELD CRIT\n");
    return 2;
  }
  const Field field = io::read_stage<Field>(io::read_input(argv[1]));
  const CriticalPoints points = io::read_stage<CriticalPoints>(io::read_input(argv[2]));
  const field::FieldEvaluator evaluator(field);
  const Comparison comparison(evaluator, points);
  std::vector<std::string> rk, ab4;
  for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12})
    rk.push_back(comparison.measure("tolerance", tolerance, [&](const trace::Launch& launch, double length) {
      return comparison.runge_kutta(launch, length, tolerance);
    }));
  for (int k = 0; k <= 9; ++k) {
    const double step = 0.01 * std::pow(0.5, k);
    ab4.push_back(comparison.measure("step", step, [&](const trace::Launch& launch, double length) {
      return comparison.adams_bashforth(launch, length, step);
    }));
  }
  fmt::print("{{\"lines\": {}, \"rk\": {}, \"ab4\": {}}}\n", comparison.num_lines(), join(rk), join(ab4));
}
