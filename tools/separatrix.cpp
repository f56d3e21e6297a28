// Traces the separatrices of a guiding field and writes the planar graph of separatrices and boundary.

#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "layout/compute_layout.hpp"
#include "trace/check_nodes_match_field.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string field_path, points_path = "-", output = "-";
  layout::LayoutOptions options;
  cli::Tool tool;
  tool.name = "separatrix";
  tool.summary = "traces the separatrices of a guiding field";
  tool.description =
      "Starts a separatrix in each direction of the cross at the irregular nodes and corners of CRIT, traces it "
      "through FIELD to the boundary, merges separatrices that meet head-on and writes the planar graph of "
      "separatrices and boundary. If the nodes of CRIT are not the zeros of the field, FIELD must be the phase that "
      "fieldsolve --nodes solved for them. Every face of the graph must have four corners; otherwise the exit code is "
      "1 and the message names the position.";
  tool.examples = {
      "separatrix half_disc.field.h5 half_disc.crit.json -o half_disc.sep.json",
      "critpoints half_disc.field.h5 | separatrix half_disc.field.h5 - | blocksplit -o half_disc.blocks.h5"};
  tool.options = [&](cli::Options& o) {
    o.input("FIELD", field_path, "guiding field (x.field.h5, x.phase.h5 or x.solve.h5)", true);
    o.input("CRIT", points_path, "its critical points (x.crit.json)");
    o.output(output, "separatrix graph to write (x.sep.json)");
    o.number("--tolerance", options.trace.tolerance, 1e-14, 1e-3, "diameters",
             "greatest error of one integration step");
    o.choice(
        "--integrator", options.trace.integrator,
        "integrator of the separatrices: Runge-Kutta in reference space with error control, or, for comparison, the "
        "paper's Adams-Bashforth in physical space with a fixed step");
    o.number("--step", options.trace.step, 0, 1e300, "file units",
             "greatest step, 0: diameter / 20; with ab4 the fixed step, 0: diameter / 500");
    o.number("--merge-angle", options.trace.merge_angle, 0, 40, "degrees",
             "merge head-on separatrices if their direction changes by less than this");
    o.number("--merge-distance", options.trace.merge_distance, 0, 1e300, "file units",
             "also merge separatrices that pass within this distance");
    o.choice(
        "--simplify", options.simplify,
        "collapse thin chords: normal, if fewer blocks outweigh the loss of block quality; coarsest, if block quality "
        "stays acceptable and no separatrix deviates from the field by more than 45 degrees");
    o.number("--max-deviation", options.max_deviation, 0, 45, "degrees",
             "greatest deviation of a simplified line from the field");
    o.formerly("--max-turn", "--max-deviation");
    o.choice(
        "--layout", options.layout,
        "traced: separatrices are traced to their ends; quantized: each stops at the first separatrix that crosses it "
        "(motorcycle graph), and an integer program decides how they continue; auto: quantized if traced fails or "
        "needs more blocks; t-mesh: only the stopped separatrices, no layout");
    o.integer("--max-lines", options.max_lines, 1, 1000000,
              "traced layout: greatest number of arcs into which separatrices cut each other");
    o.number("--max-length", options.trace.max_length, 0.01, 1e4, "diameters", "greatest length of a separatrix");
    o.number(
        "--max-total-length", options.trace.max_total_length, 0.01, 1e6, "diameters",
        "traced layout: greatest sum of the lengths of all separatrices; with auto, the quantized layout is computed "
        "if this or --max-lines is exceeded");
  };
  tool.run = [&](cli::Session& s) {
    s.begin_phase("read");
    const io::InputFile field_file = io::read_input(field_path), points_file = io::read_input(points_path);
    const Field field = io::read_field(field_file);
    const CriticalPoints points = io::read_critical_points(points_file);
    check::require_valid(check::check_field(field, check::CheckDepth::quick), field_file.name);
    check::require_valid(check::check_critical_points(points, check::CheckDepth::quick), points_file.name);
    check::require_valid(check::check_critical_points_of(points, field), points_file.name);
    const field::FieldEvaluator evaluator(field);
    // A phase that was solved for other nodes does not have this file in its provenance either: the message that states
    // the remedy must be the first.
    if (field.kind == FieldKind::phase) trace::check_nodes_match_field(evaluator, points);
    io::require_same_origin(field_file, field.provenance, points_file, points.provenance);
    if (field.kind != FieldKind::phase) trace::check_nodes_match_field(evaluator, points);
    s.begin_phase("trace");
    SeparatrixGraph graph = layout::compute_layout(evaluator, points, options, s.report());
    graph.provenance =
        s.provenance(field.provenance, {field_file.digest("field"), points_file.digest("critical-points")});
    s.begin_phase("write");
    io::write_separatrix_graph(output, graph);
    s.end_phase();
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
