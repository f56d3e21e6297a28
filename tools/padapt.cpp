// padapt: adapts the polynomial order of each element of a field, by prediction or by the paper's Algorithm 1.

#include "stage/padapt.hpp"

#include "cli/tool_main.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::PadaptOptions options;

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
  tool.options = [&](Options& o) {
    o.input("SOLVE", input, "field to adapt (x.solve.h5, x.phase.h5)");
    o.output(output, "adapted field to write (x.field.h5)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    options.validate();
    const io::InputFile file = io::read_input(input);
    const Field start = io::read_stage<Field>(file);
    io::write_stage(output, stage::padapt({start, file}, options, s));
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
