// Traces the separatrices of a guiding field and makes the planar graph of separatrices and boundary.

#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "layout/lay_out.hpp"
#include "trace/check_nodes_match_field.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string field_path, points_path = "-", output = "-";
  layout::LayoutOptions options;
  cli::Tool tool;
  tool.name = "separatrix";
  tool.summary = "traces the separatrices of a guiding field";
  tool.description =
      "Launches a line in each direction of the cross at the irregular nodes and corners of CRIT, follows it through "
      "FIELD to the boundary, merges lines that meet head on and makes the planar graph of separatrices and boundary. "
      "Where the nodes of CRIT are not the zeros of the field, FIELD is a phase that fieldsolve --nodes made for them. "
      "Every face of it must have four corners, else the exit code is 1 and the message names the place.";
  tool.examples = {
      "separatrix half_disc.field.h5 half_disc.crit.json -o half_disc.sep.json",
      "critpoints half_disc.field.h5 | separatrix half_disc.field.h5 - | blocksplit -o half_disc.blocks.h5"};
  tool.options = [&](cli::Options& o) {
    o.input("FIELD", field_path, "guiding field (x.field.h5, x.phase.h5 or x.solve.h5)", true);
    o.input("CRIT", points_path, "its critical points (x.crit.json)");
    o.output(output, "graph of separatrices (x.sep.json)");
    o.number("--tolerance", options.trace.tolerance, 1e-14, 1e-3, "diameters", "error allowed in one step of a line");
    o.choice("--integrator", options.trace.integrator, {"rk", "ab4"},
             "how lines are followed: Runge-Kutta in reference space with error control, or, to compare with, the "
             "paper's Adams-Bashforth in physical space with a fixed step");
    o.number("--step", options.trace.step, 0, 1e300, "file units",
             "greatest step along a line, 0 a 20th of the diameter; with ab4 every step, 0 a 500th");
    o.number("--merge-angle", options.trace.merge_angle, 0, 40, "degrees", "merge lines that this turns by less");
    o.number("--merge-distance", options.trace.merge_distance, 0, 1e300, "file units",
             "and lines that pass each other within this distance");
    o.choice(
        "--simplify", options.simplify, {"none", "normal", "coarsest"},
        "thin strips of blocks are taken out: normal, where that saves more than it costs in shape; coarsest, where "
        "blocks stay in fair shape and lines within 45 degrees of the field");
    o.number("--max-turn", options.max_turn, 0, 45, "degrees", "how far that may turn a line from the field");
    o.choice("--layout", options.layout, {"traced", "quantized", "auto", "t-mesh"},
             "traced: lines are followed to their ends; quantized: each stops at the first that crosses its way, and "
             "whole numbers say where it goes on; auto: quantized where traced fails or makes more blocks; t-mesh: a "
             "look at the stopped lines, no layout");
    o.integer("--max-lines", options.max_lines, 1, 1000000, "most arcs of separatrices that the graph may have");
    o.number("--max-length", options.trace.max_length, 0.01, 1e4, "diameters", "longest line that is followed");
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
    // A phase that was made for other nodes has not seen this file either: what to do about it is said first.
    if (field.kind == "phase") trace::check_nodes_match_field(evaluator, points);
    io::require_same_origin(field_file, field.provenance, points_file, points.provenance);
    if (field.kind != "phase") trace::check_nodes_match_field(evaluator, points);
    s.begin_phase("trace");
    SeparatrixGraph graph = layout::lay_out(evaluator, points, options, s.report());
    graph.provenance =
        s.provenance(field.provenance, {field_file.digest("field"), points_file.digest("critical-points")});
    s.begin_phase("write");
    io::write_separatrix_graph(output, graph);
    s.end_phase();
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
