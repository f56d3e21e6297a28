#include "adapt/adapt_loop.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "adapt/order_policy.hpp"
#include "adapt/sensor.hpp"
#include "base/error.hpp"
#include "galerkin/solve_laplace.hpp"

namespace quadrille {

namespace {

// One round: changes the orders by the sensors and says what it did.
AdaptStep change_orders(const std::vector<double>& sensors, const AdaptOptions& options, std::vector<int>& orders,
                        std::vector<bool>& was_raised) {
  AdaptStep step;
  step.min_order = *std::min_element(orders.begin(), orders.end());
  step.max_order = *std::max_element(orders.begin(), orders.end());
  step.max_sensor = *std::max_element(sensors.begin(), sensors.end());
  for (std::size_t e = 0; e < orders.size(); ++e) {
    const OrderChange change = decide(sensors[e], orders[e], was_raised[e], options);
    orders[e] += static_cast<int>(change);
    if (change == OrderChange::raise) was_raised[e] = true;
    step.num_raised += change == OrderChange::raise;
    step.num_lowered += change == OrderChange::lower;
  }
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
}

}  // namespace

void AdaptOptions::validate() const {
  if (!(lower_below < raise_above)) throw UsageError("--lower-below must be less than --raise-above");
  if (min_order > max_order) throw UsageError("--min-order must not exceed --max-order");
}

Field adapt_loop(const Field& start, const AdaptOptions& options, Report& report) {
  options.validate();
  if (start.kind != "harmonic") throw FormatError("only a harmonic field can be adapted, this one is " + start.kind);
  const SensorKind kind = sensor_kind(options.sensor);
  LaplaceSolver solver(start.mesh, options_of(start));
  Field field = start;
  std::vector<int> orders = start.elem_order;
  std::vector<bool> was_raised(orders.size(), false);
  std::vector<AdaptStep> steps;
  while (true) {
    std::vector<double> sensors = sense(field, kind);
    steps.push_back(change_orders(equalized(sensors), options, orders, was_raised));
    steps.back().num_unknowns = solver.num_unknowns(field.elem_order);
    field.elem_sensor = std::move(sensors);
    if (orders == field.elem_order) break;
    if (static_cast<int>(steps.size()) > options.max_steps) {
      report.warn("W-ADAPT-001", fmt::format("orders still change after {} {}", options.max_steps,
                                             options.max_steps == 1 ? "step" : "steps"));
      break;
    }
    field = solver.solve(orders, report);
  }
  field.provenance = start.provenance;
  field.adapt_steps = std::move(steps);
  report_result(field, options, report);
  return field;
}

}  // namespace quadrille
