// Turns the graph of separatrices into a conforming layout of four-sided blocks.

#include <optional>

#include "block/make_blocks.hpp"
#include "block/name_blocks.hpp"
#include "block/report_layout.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "io/name_rules_io.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"

using namespace quadrille;

int main(int argc, char** argv) {
  std::string input = "-", output = "-", names;
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
      "has "
      "none, they are called block_N.";
  tool.examples = {"blocksplit half_disc.sep.json -o half_disc.blocks.h5",
                   "separatrix half_disc.field.h5 half_disc.crit.json | blocksplit -o half_disc.blocks.h5",
                   "echo '{\"*\": \"fluid\"}' | blocksplit half_disc.sep.json --block-names - -o half_disc.blocks.h5"};
  tool.options = [&](Options& o) {
    o.input("SEP", input, "separatrix graph (x.sep.json)");
    o.output(output, "block layout to write (x.blocks.h5)");
    o.input_file("--block-names", names, "FILE",
                 "names of blocks, JSON: \"name of all\", {\"number\": \"name\", \"*\": \"name of the rest\"} or "
                 "[{\"at\": [x, y], \"name\": \"fluid\"}] (see formats/block-names.md)",
                 false);
  };
  tool.run = [&](cli::Session& s) {
    s.begin_phase("read");
    std::optional<io::InputFile> names_file;  // read before SEP, which may be made for long
    if (!names.empty()) names_file = io::read_input(names);
    const std::vector<NameRule> rules = names_file ? io::read_block_names(*names_file) : std::vector<NameRule>();
    const io::InputFile file = io::read_input(input);
    const SeparatrixGraph graph = io::read_separatrix_graph(file);
    check::require_valid(check::check_separatrix_graph(graph, check::CheckDepth::quick), file.name);
    s.begin_phase("blocks");
    block::Blocks blocks = block::make_blocks(graph, s.report());
    std::vector<InputDigest> inputs{file.digest("separatrix-graph")};
    if (names_file) inputs.push_back(names_file->digest("block-names"));
    block::name_blocks(blocks.layout, rules);
    blocks.layout.provenance = s.provenance(graph.provenance, inputs);
    s.info(block::summarise_layout(blocks.layout, blocks.measures));
    s.begin_phase("write");
    io::write_stage(output, blocks.layout);
    s.end_phase();
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
