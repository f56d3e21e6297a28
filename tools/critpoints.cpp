// critpoints: all critical points of a guiding field and the valences of the corners.

#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "field/error_estimate.hpp"
#include "guide/find_critical_points.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"

int main(int argc, char** argv) {
  using namespace quadrille;
  std::string input = "-", output = "-";
  Tool tool;
  tool.name = "critpoints";
  tool.summary = "finds the critical points of a guiding field";
  tool.description =
      "Reads a field and writes every zero of it once, with its index and valence, and the valence of every corner. "
      "That none is missing is proved: each element is cut into cells until a bound shows that a cell holds no zero, "
      "or "
      "at most one, which is then computed. Each has an error bar, from the estimated error of the field there.\n\n"
      "The sum of 4 - V over the critical points and of 2 - V over the corners must be four times the face's Euler "
      "characteristic (1 less the number of holes); otherwise nothing is written and the exit code is 1. So it is when "
      "the field vanishes to higher order, as at the centre of a disc.";
  tool.examples = {"critpoints half_disc.field.h5 -o half_disc.crit.json",
                   "critpoints half_disc.field.h5 | jq '.critical_points[] | select(.valence == 3) | .position'"};
  tool.options = [&](Options& o) {
    o.input("FIELD", input, "field file of padapt or fieldsolve; - is standard input");
    o.output(output, "file for the critical points; - is standard output");
  };
  tool.run = [&](Session& s) {
    s.begin_phase("read");
    const InputFile file = read_input(input);
    Field field = read_field(file);
    require_valid(check_field(field, CheckDepth::quick), file.name);
    if (field.elem_error.empty()) field.elem_error = error_estimate(field);
    s.begin_phase("search");
    const FieldEvaluator evaluator(field);
    CriticalPoints points = find_critical_points(evaluator, s.report());
    require_index_sum(points);
    s.say(std::to_string(points.critical_points.size()) + " critical points, " + std::to_string(points.corners.size()) +
          " corners, index sum " + std::to_string(points.index_sum));
    s.begin_phase("write");
    points.provenance = s.provenance(field.provenance, {file.digest("field")});
    write_critical_points(output, points);
  };
  tool.report_writer = write_report;
  return tool_main(argc, argv, tool);
}
