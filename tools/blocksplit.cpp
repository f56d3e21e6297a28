// Turns the graph of separatrices into a conforming layout of four-sided blocks.

#include "stage/blocksplit.hpp"

#include "cli/tool_main.hpp"
#include "io/name_rules_io.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-";
  stage::BlocksplitOptions options;

  cli::Tool tool;
  tool.name = "blocksplit";
  tool.summary = "turns a separatrix graph into four-sided blocks";
  tool.description =
      "Reads a separatrix graph and makes a block of each of its faces. Each face must have four sides; otherwise the "
      "exit code is 1 and the message names the position. A block is defined by its four exact sides and their "
      "transfinite blend; no order is chosen here. A block whose blend cannot be proved valid, or whose scaled "
      "Jacobian is below 0.1, is split across its long sides, together with all blocks of its chord, if that improves "
      "it. -v reports the worst and the smallest block, and which boundary features force the smallest one. Blocks "
      "have the name of their region or, where there is one region, of the CAD face, so that they are one group; if it "
      "has none, they are called block_N.";
  tool.examples = {"blocksplit half_disc.sep.json -o half_disc.blocks.h5",
                   "separatrix half_disc.field.h5 half_disc.crit.json | blocksplit -o half_disc.blocks.h5",
                   "echo '{\"*\": \"fluid\"}' | blocksplit half_disc.sep.json --block-names - -o half_disc.blocks.h5"};
  tool.options = [&](Options& o) {
    o.input("SEP", input, "separatrix graph (x.sep.json)");
    o.output(output, "block layout to write (x.blocks.h5)");
    declare(o, options);
  };
  tool.run = [&](cli::Session& s) {
    s.begin_phase("read");
    // Read before SEP, which may be made for long.
    const auto names = stage::prescribed(options.names_file, io::read_input, io::read_block_names);
    const io::InputFile file = io::read_input(input);
    const SeparatrixGraph graph = io::read_stage<SeparatrixGraph>(file);
    const BlockLayout layout = stage::blocksplit({graph, file}, names.input(), options, s);
    s.begin_phase("write");
    io::write_stage(output, layout);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
