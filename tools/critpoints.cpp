// Chooses the irregular nodes of the layout and the valences of the corners from a guiding field.

#include "stage/critpoints.hpp"

#include "cli/tool_main.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::CritpointsOptions options;

  cli::Tool tool;
  tool.name = "critpoints";
  tool.summary = "chooses the irregular nodes of the layout and the valences of the corners";
  tool.description =
      "Reads a field and finds each of its zeros once, with its index and valence, and the valence of every corner. A "
      "proof shows that none is missing: each element is cut into cells until a bound shows that a cell contains no "
      "zero, or at most one, which is then computed. Each zero has an error bar, from the estimated error of the field "
      "there.\n\n"
      "Zeros that no layout can use are replaced: multiple zeros and zeros nearer to each other than any block are "
      "split symmetrically, merged or cancelled; corners absorb adjacent zeros; nodes of small fillets and holes move "
      "onto the boundary or away from it; corner valences may be prescribed, by corner or by the kind of grid around a "
      "body, and the number of nodes reduced to what they require. Where a corner lies within 2 degrees of 45, 135, "
      "225 or 315 degrees, the field does not decide between two valences: they are chosen by rule, and the nodes are "
      "the zeros of the field with its data turned accordingly. Each change is listed in the output with its reason. "
      "Unless \"form\" is \"harmonic\" in the output, the later stages need a field solved for these nodes: fieldsolve "
      "--nodes.\n\n"
      "The sum of 4 - V over the nodes and of 2 - V over the corners must be four times the face's Euler "
      "characteristic (1 less the number of holes); otherwise nothing is written and the exit code is 1.";
  tool.examples = {"critpoints half_disc.field.h5 -o half_disc.crit.json",
                   "critpoints half_disc.field.h5 | jq '.critical_points[] | select(.valence == 3) | .position'",
                   "critpoints --place energy half_disc.field.h5 -o half_disc.placed.crit.json",
                   "critpoints --nodes fewest half_disc.field.h5 -o half_disc.fewest.crit.json",
                   "critpoints --feature-size 0.1 half_disc.field.h5 | jq '.changes'"};
  tool.options = [&](Options& o) {
    o.input("FIELD", input, "field file of padapt or fieldsolve; - is standard input");
    o.output(output, "file of the nodes and corners; - is standard output");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    options.validate();
    s.begin_phase("read");
    const io::InputFile file = io::read_input(input);
    const Field field = io::read_stage<Field>(file);
    const CriticalPoints points = stage::critpoints({field, file}, options, s);
    s.begin_phase("write");
    io::write_stage(output, points);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
