#pragma once
// What the command line of quadmesh asks for: its own options, and those of the stages, in the order of the chain.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "chain/budget.hpp"
#include "model/stage_formats.hpp"
#include "stage/blocksplit.hpp"
#include "stage/cad2chart.hpp"
#include "stage/cad2tri.hpp"
#include "stage/critpoints.hpp"
#include "stage/fieldsolve.hpp"
#include "stage/hexsweep.hpp"
#include "stage/padapt.hpp"
#include "stage/quadexport.hpp"
#include "stage/quadrefine.hpp"
#include "stage/separatrix.hpp"

namespace quadrille::chain {

enum class ChainStage {
  cad2tri,
  fieldsolve,
  padapt,
  critpoints,
  separatrix,
  blocksplit,
  quadrefine,
  hexsweep,
  quadexport
};
constexpr auto enum_names(ChainStage) {
  return std::to_array({"cad2tri", "fieldsolve", "padapt", "critpoints", "separatrix", "blocksplit", "quadrefine",
                        "hexsweep", "quadexport"});
}
constexpr int num_stages = 9;

/// Whether a stage comes before another one in the chain.
constexpr bool is_before(ChainStage stage, ChainStage other) {
  return static_cast<int>(stage) < static_cast<int>(other);
}

/// "tri.h5" of SHAPE.tri.h5; nothing for quadexport.
inline std::string ending_of(ChainStage stage) { return std::string(find_stage_tool(enum_name(stage))->ending); }

/// The options of each stage, with defaults where the command line has none.
struct StageOptions {
  stage::Cad2triOptions cad2tri;
  stage::FieldsolveOptions fieldsolve;
  stage::PadaptOptions padapt;
  stage::CritpointsOptions critpoints;
  stage::SeparatrixOptions separatrix;
  stage::BlocksplitOptions blocksplit;
  stage::QuadrefineOptions quadrefine;
  stage::HexsweepOptions hexsweep;
  stage::QuadexportOptions quadexport;
};

/// Declares those of one stage.
void declare(Options& options, ChainStage stage, StageOptions& values);

/// Words of the command line, by the command that takes them.
using Words = std::map<std::string, std::vector<std::string>>;

/// What a page shows: a tab each.
enum class PagePart { triangles, field, nodes, phase, separatrices, blocks, quads, hexahedra };
constexpr auto enum_names(PagePart) {
  return std::to_array({"triangles", "field", "nodes", "phase", "separatrices", "blocks", "quads", "hexahedra"});
}

struct ChainOptions {
  std::string shape;                  ///< path, or "-"; may be empty with `first`
  std::string output;                 ///< path; empty or "-": standard output
  std::string workdir, report, html;  ///< paths; empty: none
  std::vector<PagePart> page_parts;   ///< of the page; empty: all
  std::string nodes_file;             ///< critical points to use; "-": standard input
  std::string threads;                ///< as given; empty: auto
  int num_threads = 0;                ///< 0: auto
  Limits limits;                      ///< of seconds and memory
  ChainStage first = ChainStage::cad2tri, last = ChainStage::quadexport;
  std::string from, until;       ///< their names if they were given
  std::string converter_option;  ///< a given option of a command that converts shapes (shape_converters)
  std::string cad_option;        ///< an option of cad2tri that was given
  bool is_verbose = false, is_quiet = false, is_dry_run = false;
  bool is_swept = false;                       ///< hexsweep runs
  std::map<ChainStage, std::string> programs;  ///< external programs in place of stages, commands for a shell
  Words words;                                 ///< of each stage and of shape_converters, as given
  std::string typed;                           ///< the command, for the page: files without folders

  bool has(const std::string& tool, const std::string& flag) const;  ///< whether the words of the tool hold the flag
  bool runs(ChainStage stage) const {
    return !is_before(stage, first) && !is_before(last, stage) && (stage != ChainStage::hexsweep || is_swept);
  }
  /// Whether the file of the last stage is the output, because no folder keeps it.
  bool writes_stage_file() const { return last != ChainStage::quadexport && workdir.empty(); }
};

/// Where the mesh is written, or the file of the last stage; "-": standard output.
inline std::string output_of(const ChainOptions& options) { return options.output.empty() ? "-" : options.output; }

/// The name from which the format of the mesh follows. That of a stage file does not determine it.
inline std::string mesh_name_of(const ChainOptions& options) {
  return options.writes_stage_file() ? "-" : output_of(options);
}

/// Reads the command line (argv without the name of the program), which asks for work (cli/outcome). Throws UsageError.
void read_command_line(const std::vector<std::string>& arguments, ChainOptions& options);

/// The values of the words of each stage. Throws UsageError with the message of the stage.
StageOptions stage_options(const ChainOptions& options);

/// The texts of --help, a page, of --help-all, and of --list-options: a line "quadmesh --OPTION KIND" (cli::OptionKind)
/// for each but --output.
std::string help_text();
std::string full_help_text();
std::string option_list();

/// For a shell, quoted where necessary.
std::string shell_command(const std::vector<std::string>& words);

}  // namespace quadrille::chain
