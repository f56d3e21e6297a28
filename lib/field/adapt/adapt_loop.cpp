#include "adapt/adapt_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <memory>

#include "adapt/order_policy.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "field/error_estimate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "galerkin/solve_phase.hpp"
#include "surface/positions.hpp"

namespace quadrille::adapt {

namespace {

struct PredictionConstants {
  // Predictions aim at a sensor below the one that makes them necessary, so that few elements have to be corrected.
  double aim = 0.02;
  double trusted_rate = 0.9;  // the part of the expected rate of decay that predictions rely on
};
constexpr PredictionConstants prediction;

// Solves for a field of the same kind and options as the initial one, with other orders.
struct Solver {
  std::function<Field(const std::vector<int>& orders, Report& report)> solve;
  std::function<int(const std::vector<int>& orders)> num_unknowns;
  std::function<const field::PhaseBoundary*()> phase_boundary;  // of the last solution; null for a harmonic field
};

Solver solver_of(const Field& start, int num_threads) {
  if (start.kind == FieldKind::phase) {
    const auto solver =
        std::make_shared<galerkin::PhaseSolver>(start.mesh, start.elem_order, num_threads, start.alignment);
    return {[=, &start](const std::vector<int>& orders, Report& report) {
              solver->set_orders(orders);
              return solver->solve(start.phase.prescribed, start.phase.hole_winding_offsets, report);
            },
            [=](const std::vector<int>& orders) { return solver->num_unknowns(orders); },
            [=] { return solver->boundary(); }};
  }
  galerkin::LaplaceOptions options = galerkin::options_of(start);
  options.num_threads = num_threads;
  const auto solver = std::make_shared<galerkin::LaplaceSolver>(start.mesh, options);
  return {[=](const std::vector<int>& orders, Report& report) { return solver->solve(orders, report); },
          [=](const std::vector<int>& orders) { return solver->num_unknowns(orders); }, [] { return nullptr; }};
}

// The adaptation history stored in `field`, without its last round, which is repeated as the first round now;
// `was_raised` marks the elements that the history raised. A history that does not end with the orders of this field is
// ignored.
std::vector<AdaptStep> history_of(const Field& field, std::vector<bool>& was_raised) {
  const std::size_t num_elems = field.elem_order.size();
  std::vector<AdaptStep> steps = field.adapt_steps;
  const bool is_whole = std::all_of(steps.begin(), steps.end(),
                                    [&](const AdaptStep& step) { return step.elem_order.size() == num_elems; });
  if (!is_whole || steps.empty() || steps.back().elem_order != field.elem_order) return {};
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    for (std::size_t e = 0; e < num_elems; ++e) {
      if (steps[i + 1].elem_order[e] > steps[i].elem_order[e]) was_raised[e] = true;
    }
  }
  steps.pop_back();
  return steps;
}

// Orders by Algorithm 1.
void step_orders(const std::vector<double>& sensors, const AdaptOptions& options, std::vector<int>& orders,
                 std::vector<bool>& was_raised) {
  for (std::size_t e = 0; e < orders.size(); ++e) {
    const OrderChange change = decide(sensors[e], orders[e], was_raised[e], options);
    orders[e] += static_cast<int>(change);
    if (change == OrderChange::raise) was_raised[e] = true;
  }
}

// The order of an element for the next solution, not rounded. It is lowered to where the sensor is about --lower-below,
// not to where it just meets the other limit: the errors of many elements add up.
double next_order(const std::vector<double>& sensors, const AdaptOptions& options) {
  const double order = static_cast<double>(sensors.size()) - 1;
  const double predicted = predicted_order(sensors, prediction.aim * options.raise_above, prediction.trusted_rate);
  if (predicted >= order) return predicted;
  return std::clamp(predicted_order(sensors, options.lower_below, prediction.trusted_rate), predicted, order);
}

// Orders by prediction: in the first round of all elements, then of those that exceed the limit. A solution that is
// good enough is kept: lower orders would cost a solution.
void predict_orders(const Field& field, const AdaptOptions& options, bool is_first, std::vector<int>& orders) {
  const std::vector<std::vector<double>> sensors = degree_sensors(field, options.sensor, options.scale);
  const auto is_resolved = [&](const std::vector<double>& of_degrees) {
    return of_degrees.back() <= options.raise_above;
  };
  if (is_good_enough(element_sensors(field, options.sensor, options.scale), options.raise_above)) return;
  std::vector<double> powers;  // e to the predicted orders, because equalized() compares ratios
  for (const std::vector<double>& of_degrees : sensors) powers.push_back(std::exp(next_order(of_degrees, options)));
  powers = equalized(std::move(powers));
  for (std::size_t e = 0; e < orders.size(); ++e) {
    const int predicted = static_cast<int>(std::ceil(std::log(powers[e]) - 1e-9));
    if (!is_first && (predicted <= orders[e] || is_resolved(sensors[e]))) continue;
    orders[e] = std::clamp(predicted, options.min_order, options.max_order);
  }
}

// A record of the round that changes the orders of `field` to `orders`.
AdaptStep step_of(const Field& field, const std::vector<int>& orders, std::vector<double> sensors) {
  AdaptStep step;
  step.min_order = *std::min_element(field.elem_order.begin(), field.elem_order.end());
  step.max_order = *std::max_element(field.elem_order.begin(), field.elem_order.end());
  step.max_sensor = *std::max_element(sensors.begin(), sensors.end());
  for (std::size_t e = 0; e < orders.size(); ++e) {
    step.num_raised += orders[e] > field.elem_order[e];
    step.num_lowered += orders[e] < field.elem_order[e];
  }
  step.elem_order = field.elem_order;
  step.elem_sensor = std::move(sensors);
  return step;
}

void report_result(const Field& field, const AdaptOptions& options, Report& report) {
  const AdaptStep& last = field.adapt_steps.back();
  int num_unresolved = 0;
  for (const double sensor : field.elem_sensor) num_unresolved += sensor > options.raise_above;
  report.set("adapt.steps", field.adapt_steps.size());
  report.set("adapt.num_unknowns", last.num_unknowns);
  report.set("adapt.min_order", last.min_order);
  report.set("adapt.max_order", last.max_order);
  report.set("adapt.max_sensor", last.max_sensor);
  report.set("adapt.num_unresolved", num_unresolved);
  report.set("adapt.max_error", *std::max_element(field.elem_error.begin(), field.elem_error.end()));
  std::vector<double> unknowns, sensors;
  for (const AdaptStep& step : field.adapt_steps) {
    unknowns.push_back(step.num_unknowns);
    sensors.push_back(step.max_sensor);
  }
  report.set("adapt.num_unknowns_by_step", Report::Value(unknowns));
  report.set("adapt.max_sensor_by_step", Report::Value(sensors));
}

// With as many digits as it takes to read otherwise than the target, which is shown with two.
std::string text_above(double error, double target) {
  std::string text;
  for (int digits = 1; digits <= 16; ++digits) {
    text = fmt::format("{:.{}e}", error, digits);
    if (text != fmt::format("{:.{}e}", target, digits)) break;
  }
  return text;
}

// Reports how many elements at max_order miss the target error, by how much, and the position of the worst one.
// Elements of fans are weighted by their size, as in the sensor.
void judge_errors(const Field& field, const AdaptOptions& options, Report& report) {
  const std::vector<double> weights = fan_weights(field.mesh);
  int num_missing = 0, worst = -1;
  double greatest = options.target_error;
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    const double error = std::sqrt(weights[e]) * field.elem_error[e];
    if (field.elem_order[e] < options.max_order || !(error > options.target_error)) continue;
    ++num_missing;
    if (error > greatest) {
      greatest = error;
      worst = e;
    }
  }
  report.set("adapt.num_missing_target", num_missing);
  if (num_missing == 0) return;
  const auto& [a, b, c] = field.mesh.elem2vertices[worst];
  const std::vector<Vec2>& x = field.mesh.vertices;
  const std::string position = surface::position_text(field.mesh.face, (x[a] + x[b] + x[c]) / 3);
  report.warn(warning::target_error_missed,
              fmt::format("the estimated error of the field is up to {}, above the target {:.1e}, although the order "
                          "is at its highest, {}: {} {}, the worst near {}",
                          text_above(greatest, options.target_error), options.target_error, options.max_order,
                          num_missing, num_missing == 1 ? "element" : "elements", position));
}

}  // namespace

void AdaptOptions::validate() const {
  if (!(lower_below < raise_above)) throw UsageError("--lower-below must be less than --raise-above");
  if (min_order > max_order) throw UsageError("--min-order must not exceed --max-order");
}

Field adapt_loop(const Field& start, const AdaptOptions& requested, Report& report) {
  AdaptOptions options = requested;
  options.max_order = std::min(options.max_order, galerkin::max_field_order(start.method));
  options.validate();
  const Solver solver = solver_of(start, options.num_threads);
  Field field = start;
  std::vector<int> orders = start.elem_order;
  std::vector<bool> was_raised(orders.size(), false);
  std::vector<AdaptStep> steps = history_of(start, was_raised);
  std::vector<double> seconds;  // CPU time of each new solution
  const Progress::Part solutions(report.progress(), "solutions", options.max_steps, Progress::Total::bound);
  for (int round = 0;; ++round) {
    field.elem_sensor = element_sensors(field, options.sensor, options.scale);
    if (options.policy == AdaptPolicy::paper)
      step_orders(equalized(field.elem_sensor), options, orders, was_raised);
    else
      predict_orders(field, options, steps.empty(), orders);
    steps.push_back(step_of(field, orders, field.elem_sensor));
    steps.back().num_unknowns = solver.num_unknowns(field.elem_order);
    if (orders == field.elem_order) break;
    if (round == options.max_steps) {
      report.warn(warning::orders_still_change, fmt::format("orders still change after {} {}", options.max_steps,
                                                            options.max_steps == 1 ? "step" : "steps"));
      break;
    }
    const std::clock_t begin = std::clock();
    field = solver.solve(orders, report);
    solutions.advance();
    seconds.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  field.provenance = start.provenance;
  field.adapt_steps = std::move(steps);
  if (field.elem_error.empty())
    field.elem_error = field::error_estimate(field, solver.phase_boundary(), report.progress());
  report.set("adapt.cpu_seconds_by_step", Report::Value(seconds));
  report_result(field, options, report);
  judge_errors(field, options, report);
  return field;
}

}  // namespace quadrille::adapt
