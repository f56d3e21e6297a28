#include "stage/blocksplit.hpp"

#include "base/options.hpp"
#include "block/extract_blocks.hpp"
#include "block/make_blocks.hpp"
#include "block/report_layout.hpp"
#include "check/check.hpp"

namespace quadrille::stage {

void declare(Options& o, BlocksplitOptions& blocksplit) {
  o.input_file("--block-names", blocksplit.names_file, "FILE",
               "names of blocks, JSON: \"name of all\", {\"number\": \"name\", \"*\": \"name of the rest\"} or "
               "[{\"at\": [x, y], \"name\": \"fluid\"}] (see formats/block-names.md)",
               false);
}

BlockLayout blocksplit(const Input<SeparatrixGraph>& graph, const std::optional<Input<std::vector<NameRule>>>& names,
                       const BlocksplitOptions& options, Run& run) {
  require_intervals(options);
  check::require_sound(graph.model, graph.file.name);
  run.begin_phase("blocks");
  block::Blocks blocks = block::make_blocks(graph.model, run.report());
  std::vector<InputDigest> inputs{graph.file.digest("separatrix-graph")};
  if (names) inputs.push_back(names->file.digest("block-names"));
  block::name_blocks(blocks.layout, names ? names->model : std::vector<NameRule>());
  blocks.layout.provenance = with_step(graph.model.provenance, "blocksplit", options, std::move(inputs));
  run.info(block::summarise_layout(blocks.layout, blocks.measures));
  run.end_phase();
  return std::move(blocks.layout);
}

}  // namespace quadrille::stage
