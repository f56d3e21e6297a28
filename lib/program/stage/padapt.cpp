#include "stage/padapt.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "adapt/adapt_loop.hpp"
#include "base/options.hpp"
#include "check/check.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"

namespace quadrille::stage {

namespace {

// Number of elements of each order, from 0 on.
std::vector<double> order_histogram(const Field& field) {
  std::vector<double> counts(1 + *std::max_element(field.elem_order.begin(), field.elem_order.end()), 0.0);
  for (const int order : field.elem_order) ++counts[order];
  return counts;
}

}  // namespace

void declare(Options& o, PadaptOptions& padapt) {
  o.choice("--policy", padapt.policy,
           "change an order to what the decay of the modes predicts, or by one in each round, as in the paper");
  o.number("--raise-above", padapt.raise_above, 0, 1, "squared ratio",
           "raise the order of elements whose sensor exceeds this");
  o.number("--lower-below", padapt.lower_below, 0, 1, "squared ratio",
           "lower the order of elements whose sensor is below this");
  o.integer("--min-order", padapt.min_order, 1, 20, "lowest order");
  o.integer("--max-order", padapt.max_order, 1, 20, "highest order (dg: at most 12)");
  o.integer("--max-steps", padapt.max_steps, 0, 100,
            "greatest number of new solutions; a warning is given if it is reached");
  o.number("--target-error", padapt.target_error, 0, 1, "magnitude of the field",
           "estimated error that elements at the highest order should reach; a warning is given if they do not");
  o.choice("--sensor", padapt.sensor, "components that the sensor uses");
  o.choice(
      "--sensor-scale", padapt.scale,
      "reference of the sensor: the magnitude of the field on the boundary, or that of the components on the element "
      "(as in the paper)");
}

Field padapt(const Input<Field>& start, const PadaptOptions& options, Run& run) {
  require_intervals(options);
  options.validate();
  check::require_sound(start.model, start.file.name);
  run.begin_phase("adapt");
  const std::vector<Field> starts = regions::split(start.model);
  std::vector<Field> parts = regions::map_regions<Field>(
      start.model.mesh.face, run.threads(), run.report(), [&](int region, int threads, Report& report) {
        adapt::AdaptOptions part_options = options;
        part_options.num_threads = threads;
        return adapt::adapt_loop(starts[region], part_options, report);
      });
  run.end_phase();
  Field field = regions::join(start.model.mesh, std::move(parts));
  field.provenance = with_step(start.model.provenance, "padapt", options, {start.file.digest("field")});
  run.report().set("adapt.num_elements_by_order", Report::Value(order_histogram(field)));
  for (const AdaptStep& step : field.adapt_steps)
    run.info(fmt::format("orders {}..{}, {} unknowns, sensor up to {:.1e}: {} raised, {} lowered", step.min_order,
                         step.max_order, step.num_unknowns, step.max_sensor, step.num_raised, step.num_lowered));
  return field;
}

}  // namespace quadrille::stage
