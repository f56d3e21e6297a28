// padapt: adapts the polynomial order of each element of a field, by prediction or by the paper's Algorithm 1.

#include <fmt/format.h>

#include <algorithm>

#include "adapt/adapt_loop.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "regions/join.hpp"
#include "regions/region_work.hpp"
#include "regions/split.hpp"

using namespace quadrille;

namespace {

// Number of elements of each order, from 0 on.
std::vector<double> order_histogram(const Field& field) {
  std::vector<double> counts(1 + *std::max_element(field.elem_order.begin(), field.elem_order.end()), 0.0);
  for (const int order : field.elem_order) ++counts[order];
  return counts;
}

}  // namespace

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  adapt::AdaptOptions options;

  cli::Tool tool;
  tool.name = "padapt";
  tool.summary = "adapts the polynomial order of a field, element by element";
  tool.description =
      "Reads the field SOLVE and estimates the error of each element by the part of its solution in the modes of the "
      "highest degree (the sensor). Predicts from the decay of the modes the order at which the sensor is below "
      "--raise-above, changes the orders to it, solves again, and raises the orders of elements whose sensor is still "
      "above it, until there are none, or at most one element of 1000, each at most tenfold above it. With --policy "
      "paper, each round raises the order of an element by one if its "
      "sensor exceeds --raise-above and lowers it by one if it is below --lower-below; an order that was raised is not "
      "lowered again (Algorithm 1 of the paper). The sensor is a squared ratio: 1e-20 is a relative tail of 1e-10. A "
      "field that was adapted before is adapted further and keeps its history, so that --max-steps 1 performs one step "
      "at a time. A field for prescribed nodes (x.phase.h5) is solved for them again; its sensor uses its only "
      "unknown, "
      "the phase in radians, and ignores --sensor.";
  tool.examples = {"padapt half_disc.solve.h5 -o half_disc.field.h5",
                   "padapt --max-order 12 --raise-above 1e-14 half_disc.solve.h5 -o half_disc.field.h5",
                   "fieldsolve half_disc.tri.h5 | padapt --sensor u -o half_disc.field.h5"};
  tool.options = [&](cli::Options& o) {
    o.input("SOLVE", input, "field to adapt (x.solve.h5, x.phase.h5)");
    o.output(output, "adapted field to write (x.field.h5)");
    o.choice("--policy", options.policy,
             "change an order to what the decay of the modes predicts, or by one in each round, as in the paper");
    o.number("--raise-above", options.raise_above, 0, 1, "squared ratio",
             "raise the order of elements whose sensor exceeds this");
    o.number("--lower-below", options.lower_below, 0, 1, "squared ratio",
             "lower the order of elements whose sensor is below this");
    o.integer("--min-order", options.min_order, 1, 20, "lowest order");
    o.integer("--max-order", options.max_order, 1, 20, "highest order (dg: at most 12)");
    o.integer("--max-steps", options.max_steps, 0, 100,
              "greatest number of new solutions; a warning is given if it is reached");
    o.number("--target-error", options.target_error, 0, 1, "magnitude of the field",
             "estimated error that elements at the highest order should reach; a warning is given if they do not");
    o.choice("--sensor", options.sensor, "components that the sensor uses");
    o.choice(
        "--sensor-scale", options.scale,
        "reference of the sensor: the magnitude of the field on the boundary, or that of the components on the element "
        "(as in the paper)");
  };
  tool.run = [&](cli::Session& s) {
    options.validate();
    const io::InputFile file = io::read_input(input);
    const Field start = io::read_field(file);
    check::require_valid(check::check_field(start, check::CheckDepth::quick), file.name);
    s.begin_phase("adapt");
    const std::vector<Field> starts = regions::split(start);
    std::vector<Field> parts = regions::map_regions<Field>(
        start.mesh.face, s.threads(), s.report(), [&](int region, int threads, Report& report) {
          adapt::AdaptOptions part_options = options;
          part_options.num_threads = threads;
          return adapt::adapt_loop(starts[region], part_options, report);
        });
    s.end_phase();
    Field field = regions::join(start.mesh, std::move(parts));
    field.provenance = s.provenance(start.provenance, {file.digest("field")});
    s.report().set("adapt.num_elements_by_order", Report::Value(order_histogram(field)));
    for (const AdaptStep& step : field.adapt_steps) {
      s.info(fmt::format("orders {}..{}, {} unknowns, sensor up to {:.1e}: {} raised, {} lowered", step.min_order,
                         step.max_order, step.num_unknowns, step.max_sensor, step.num_raised, step.num_lowered));
    }
    io::write_field(output, field);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
