#pragma once
// The state of a run of the chain, from a CAD file to an exported mesh. The steps are in the other headers of this
// folder; run_chain calls them in their order.

#include <optional>
#include <set>
#include <string>

#include "chain/chain_options.hpp"
#include "chain/stage_file.hpp"
#include "chain/stage_runner.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

/// The files that follow from one choice of nodes.
struct NodeFiles {
  explicit NodeFiles(const std::string& stem)
      : nodes(stem + ".crit.json"),
        phase_solve(stem + ".phase.solve.h5"),
        phase(stem + ".phase.h5"),
        graph(stem + ".sep.json"),
        blocks(stem + ".blocks.h5") {}

  StageFile<CriticalPoints> nodes;
  StageFile<Field> phase_solve, phase;
  StageFile<SeparatrixGraph> graph;
  StageFile<BlockLayout> blocks;
};

/// All files of a run, STEM.tri.h5 and so on.
struct ChainFiles {
  explicit ChainFiles(const std::string& file_stem)
      : stem(file_stem),
        triangles(stem + ".tri.h5"),
        solve(stem + ".solve.h5"),
        field(stem + ".field.h5"),
        of_nodes(stem),
        quads(stem + ".quad.h5") {}

  std::string stem;
  StageFile<TriMesh> triangles;
  StageFile<Field> solve, field;
  NodeFiles of_nodes;
  StageFile<QuadMesh> quads;
};

/// A failure that ends the run.
struct ChainFailure {
  ExitCode code = ExitCode::done;
  std::string stage;    ///< or "quadmesh"
  std::string message;  ///< for the report
  bool is_printed = true;
};

/// Of the names of stages in the report: runs whose results are not used.
inline constexpr const char* prefix_of_trials = "trial_";

struct ChainState {
  ChainState(const ChainOptions& chosen, const StageOptions& of_stages, StageRunner& of_run, const std::string& stem)
      : options(chosen), values(of_stages), runner(of_run), files(stem) {}

  const ChainOptions& options;
  StageOptions values;
  Words added;  ///< words that the run adds to those of the command line
  StageRunner& runner;
  ChainFiles files;
  std::optional<std::string> standard_input;  ///< its bytes, if it is the shape or the nodes
  bool keeps_files = false;                   ///< files are written, not only kept in memory
  bool has_other_way = false;                 ///< if the field has no valid result, triangles may be divided
  bool has_fixed_nodes = false;               ///< given by the user, or edited: they are not replaced
  std::optional<NodeForm> form;               ///< of the nodes in use
  std::size_t num_nodes = 0;
  std::string prefix;                      ///< of the names of stages in the report
  std::string comment;                     ///< before the commands of --dry-run
  std::set<std::string> printed_warnings;  ///< codes and texts
  std::string last;                        ///< path of the last file that was made
  std::string remedy;                      ///< words for critpoints that gave a layout, or a better one
  std::vector<io::LayoutTrial> trials;     ///< meshes that were compared, in the order of their runs
  std::optional<StageEnd> given_up;        ///< the stage without a valid result after which the run went on

  bool is_due(ChainStage stage) const { return !is_before(stage, options.first) && !is_before(options.last, stage); }
};

/// A sentence of quadmesh itself on standard error, but not with -q.
void inform(const ChainState& chain, const std::string& text);

/// Prints the warnings of the runs from this one on, each text once in a run of the chain.
void print_warnings(ChainState& chain, std::size_t first_run);

/// Prints that the last stage without a result was stopped, and that the quads are made without a field.
void print_stop(const ChainState& chain);

/// The words of a stage on the command line and those that were added.
std::vector<std::string> chosen_words(const ChainState& chain, ChainStage stage);

/// Runs the task if its stage is due, and prints its warnings. Returns false if it found no valid result, or was
/// stopped, and there is another way. Throws ChainFailure otherwise.
bool run_stage(ChainState& chain, StageTask task);

}  // namespace quadrille::chain
