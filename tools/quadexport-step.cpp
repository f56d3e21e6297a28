// Private helper of quadexport: writes blocks as STEP. A separate program, because every process that links the CAD
// kernel pays for its start-up.

#include <fmt/format.h>

#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "export/groups.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"
#include "model/length_scale.hpp"
#include "occ/write_cad.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  ScaleRequest request;
  request.keeps_unit = true;
  bool has_block_groups = false;
  cli::Tool tool;
  tool.name = "quadexport";
  tool.summary = "writes the blocks of a block layout as a STEP model of connected faces";
  tool.description = "Run by quadexport, which has the user's options; not meant to be called by hand.";
  tool.options = [&](Options& o) {
    o.input("BLOCKS", input, "block layout (x.blocks.h5), - for standard input");
    o.output(output, "STEP file");
    o.text("--unit", request.unit, "UNIT", "length unit of the model, as quadexport has checked it");
    o.number("--scale", request.scale, 1e-12, 1e12, "factor", "multiply the coordinates by this, after --unit");
    o.flag("--block-groups", has_block_groups, "name the faces of blocks without a name by their numbers");
  };
  tool.run = [&](cli::Session&) {
    const io::InputFile file = io::read_input(input);
    BlockLayout layout = io::read_block_layout(file);
    check::require_valid(check::check_block_layout(layout, check::CheckDepth::quick), file.name);
    if (request.unit == "file" && !occ::has_step_unit(layout.face)) request.unit = "mm";
    const LengthScale length = length_scale(layout.face, request);
    scale_lengths(layout, length);
    if (has_block_groups) exports::separate_blocks(layout);
    layout.block_names = exports::region_of_blocks(layout);
    io::write_output(output, occ::step_of_blocks(layout), false);
    // For the report of quadexport, which reads this line from standard error.
    fmt::print(stderr, "{} {:.17g} {}\n", layout.num_blocks(), length.factor, length.unit);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
