#pragma once
// The state of a run of the chain, from a CAD file to an exported mesh. The steps are in the other headers of this
// folder; run_chain calls them in their order.

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "chain/chain_options.hpp"
#include "chain/stage_runner.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::chain {

/// A stage file of the chain: a struct in memory, a file, or both.
template <typename Model>
class StageFile {
 public:
  /// `path`: where the file is, or would be.
  explicit StageFile(std::string path) : path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  /// The struct with the name and digest of its file; read from there if it is not in memory. Throws FormatError.
  stage::Input<Model> input() {
    if (!model_) read(io::read_input(path_));
    return {*model_, {name(), sha256_}};
  }
  const Model& model() { return input().model; }

  const std::string& name() const { return name_.empty() ? path_ : name_; }  ///< for messages
  /// The struct, which is then no longer kept.
  Model release() {
    if (!model_) read(io::read_input(path_));
    Model model = std::move(*model_);
    model_.reset();
    return model;
  }
  /// Keeps the struct. With `is_written`, its file is written and so its digest known. Throws OutputError.
  void set(Model model, bool is_written) {
    model_ = std::move(model);
    sha256_.clear();
    if (is_written) write();
  }
  /// Writes the file, if it is not there.
  void write() {
    if (!model_ || !sha256_.empty()) return;
    const std::string bytes = io::stage_bytes(*model_);
    io::write_stage_bytes(path_, bytes, io::Lasting::for_the_run);  // the same command makes it again
    sha256_ = io::identity_of(path_, bytes).sha256;
  }
  /// The file was written by another program: the struct is read when it is needed.
  void forget() {
    model_.reset();
    sha256_.clear();
  }
  /// Reads the struct from the bytes of another file.
  void read(const io::InputFile& file) {
    model_ = io::read_stage<Model>(file);
    sha256_ = file.sha256;
    name_ = file.name;
  }
  /// Takes the struct of another file, which is then empty; the file itself is not touched.
  void take(StageFile& other) {
    model_ = std::exchange(other.model_, std::nullopt);
    sha256_ = std::exchange(other.sha256_, {});
    name_.clear();
  }
  bool is_in_memory() const { return model_.has_value(); }

 private:
  std::string path_;
  std::string name_;  ///< of the file that it was read from, if that is another one
  std::optional<Model> model_;
  std::string sha256_;  ///< empty: there is no file, as far as is known
};

/// The files that follow from one choice of nodes.
struct NodeFiles {
  explicit NodeFiles(const std::string& stem)
      : nodes(stem + ".crit.json"),
        phase_solve(stem + ".phase.solve.h5"),
        phase(stem + ".phase.h5"),
        graph(stem + ".sep.json"),
        blocks(stem + ".blocks.h5"),
        quads(stem + ".quad.h5") {}

  StageFile<CriticalPoints> nodes;
  StageFile<Field> phase_solve, phase;
  StageFile<SeparatrixGraph> graph;
  StageFile<BlockLayout> blocks;
  StageFile<QuadMesh> quads;
};

/// All files of a run, STEM.tri.h5 and so on.
struct ChainFiles {
  explicit ChainFiles(const std::string& file_stem)
      : stem(file_stem),
        triangles(stem + ".tri.h5"),
        solve(stem + ".solve.h5"),
        field(stem + ".field.h5"),
        of_nodes(stem),
        hexes(stem + ".hex.h5") {}

  std::string stem;
  StageFile<TriMesh> triangles;
  StageFile<Field> solve, field;
  NodeFiles of_nodes;
  StageFile<HexMesh> hexes;
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
  Words added;     ///< words that the run adds to those of the command line
  Words replaced;  ///< words of a stage in place of both
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

  bool is_due(ChainStage stage) const { return options.runs(stage); }
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

/// The same for a task that makes `result`, which is what compute(Run&) returns, from `inputs`. Without words, these
/// are the inputs.
template <typename Model, typename Compute, typename... Inputs>
bool make_file(ChainState& chain, StageTask task, StageFile<Model>& result, const Compute& compute,
               StageFile<Inputs>&... inputs) {
  if (task.words.empty()) task.words = {inputs.name()...};
  task.output = result.path();
  task.compute = [&](Run& run) { result.set(compute(run), chain.keeps_files); };
  task.write_inputs = [&] { (inputs.write(), ...); };
  task.drop_result = [&] { result.forget(); };
  return run_stage(chain, std::move(task));
}

}  // namespace quadrille::chain
