#include "chain/early_checks.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "base/error.hpp"
#include "chain/chain_inputs.hpp"
#include "chain/chain_nodes.hpp"
#include "chain/shape_converters.hpp"
#include "cli/outcome.hpp"
#include "cli/run_files.hpp"
#include "cli/stage_words.hpp"

namespace quadrille::chain {

namespace {

namespace fs = std::filesystem;

void check_range(const ChainOptions& options) {
  if (is_before(options.last, options.first))
    throw UsageError(fmt::format("--from {} comes after --until {}: no stage would run", options.from, options.until));
  if (options.first != ChainStage::cad2tri && options.workdir.empty())
    throw UsageError(
        fmt::format("--from {} needs --workdir, the folder with the files of the stages before", options.from));
  if ((options.first == ChainStage::hexsweep || options.last == ChainStage::hexsweep) && !options.is_swept)
    throw UsageError("the stage hexsweep runs with --sweep only");
  if (const auto words = options.words.find("hexsweep"); words != options.words.end() && !options.is_swept)
    for (const std::string& word : words->second)
      if (word.starts_with("--") && word != "--allow-invalid")
        throw UsageError(fmt::format("{} is an option of hexsweep: give --sweep too", word));
}

/// Whether a stage takes the flag too, this one or a later one.
bool has_taker(const ChainOptions& options, ChainStage first, const std::string& flag) {
  for (int i = static_cast<int>(first); i < num_stages; ++i)
    if (options.has(enum_name(static_cast<ChainStage>(i)), flag)) return true;
  return false;
}

/// Options of stages before --from could not change anything.
void check_skipped_options(const ChainOptions& options) {
  if (options.first == ChainStage::cad2tri) return;
  if (!options.cad_option.empty())
    throw UsageError(fmt::format("{} is an option of cad2tri, which --from {} does not run: leave one of them out",
                                 options.cad_option, options.from));
  if (const ShapeConverter* converter = converter_with_option(options.converter_option))
    throw UsageError(fmt::format("{} makes a CAD file of {}, which --from {} does not read: leave one of them out",
                                 options.converter_option, converter->input, options.from));
  for (const ChainStage stage : {ChainStage::critpoints, ChainStage::separatrix, ChainStage::blocksplit,
                                 ChainStage::quadrefine, ChainStage::hexsweep}) {
    const auto words = options.words.find(enum_name(stage));
    if (!is_before(stage, options.first) || words == options.words.end()) continue;
    for (const std::string& word : words->second)
      if (word.starts_with("--") && !has_taker(options, options.first, word))
        throw UsageError(
            fmt::format("{} is an option of {}, which --from {} does not run: leave it out, or begin with --from {}",
                        word, enum_name(stage), options.from, enum_name(stage)));
  }
}

/// What the stages refuse before they read a file.
void check_stage_options(const StageOptions& values) {
  values.cad2tri.validate();
  values.critpoints.validate();
  values.separatrix.validate();
  values.quadrefine.validate();
  values.hexsweep.validate();
}

/// A stage file under the name of a mesh would mislead.
void check_name_of_stage_file(const ChainOptions& options) {
  if (!options.writes_stage_file()) return;
  const std::string ending = ending_of(options.last), extension = ending.substr(ending.rfind('.'));
  const std::string name = options.output.substr(options.output.rfind('/') + 1);  // npos + 1 is 0
  if (name.find('.') != std::string::npos && !name.ends_with(extension))
    throw UsageError(fmt::format("{}: --until {} writes x.{}: end the name in {}, or give --workdir", options.output,
                                 options.until, ending, extension));
}

void check_output_format(const ChainOptions& options, const StageOptions& values) {
  const std::string format = stage::format_of(mesh_name_of(options), values.quadexport);
  if (options.last != ChainStage::quadexport) return;
  if (options.is_swept)
    stage::require_hexahedra(format, values.quadrefine.refine.order, values.quadexport);
  else
    stage::require_order(format, values.quadrefine.refine.order, values.quadexport);
}

void check_nodes_option(const ChainOptions& options, const StageOptions& values) {
  if (options.nodes_file.empty()) return;
  if (values.separatrix.layout == layout::LayoutChoice::midpoint)
    throw UsageError("--nodes and --layout midpoint exclude each other: it uses no nodes");
  if (is_before(ChainStage::separatrix, options.first))
    throw UsageError(fmt::format("--nodes needs separatrix, which --from {} does not run", options.from));
  if (is_before(options.last, ChainStage::critpoints))
    throw UsageError(fmt::format("--nodes is not used before critpoints, where --until {} ends", options.until));
  if (const auto words = options.words.find("critpoints"); words != options.words.end())
    for (const std::string& word : words->second)
      if (word.starts_with("--") && !has_taker(options, ChainStage::separatrix, word))
        throw UsageError(
            fmt::format("--nodes takes the place of critpoints: {} is an option of it, leave it out", word));
  if (options.nodes_file == "-" && options.shape == "-")
    throw UsageError("SHAPE and --nodes cannot both be standard input");
}

/// Endings of the files that the first stage reads.
std::vector<std::string> needed_endings(const ChainOptions& options, const StageOptions& values) {
  const bool has_no_field = values.separatrix.layout == layout::LayoutChoice::midpoint;
  switch (options.first) {
    case ChainStage::cad2tri:
      return {};
    case ChainStage::fieldsolve:
      return {"tri.h5"};
    case ChainStage::padapt:
      if (has_no_field) return {"tri.h5"};
      return {"tri.h5", "solve.h5"};
    case ChainStage::critpoints:
      if (has_no_field) return {"tri.h5"};
      return {"tri.h5", "field.h5"};
    case ChainStage::separatrix:
      if (has_no_field) return {"tri.h5"};
      if (!options.nodes_file.empty()) return {"tri.h5", "field.h5"};
      return {"tri.h5", "field.h5", "crit.json"};
    case ChainStage::blocksplit:
      return {"sep.json"};
    case ChainStage::quadrefine:
      return {"blocks.h5"};
    case ChainStage::hexsweep:
      return {"quad.h5"};
    case ChainStage::quadexport:
      return {exported_ending(options, values)};
  }
  return {};
}

std::string maker_of(const std::string& ending) {
  for (const StageTool& tool : stage_tools)
    if (tool.ending == ending) return std::string(tool.name);
  return {};
}

void require_stage_files(const ChainState& chain) {
  for (const std::string& ending : needed_endings(chain.options, chain.values)) {
    const std::string path = chain.files.stem + '.' + ending;
    std::error_code error;
    if (fs::file_size(path, error) == 0 || error)
      throw FormatError(fmt::format("--from {} needs {}, which does not exist or is empty: begin with {} or before",
                                    chain.options.from, path, maker_of(ending)));
  }
}

/// Exists, can be read, is not empty.
void require_input(const std::string& path) {
  if (path.empty() || path == "-") return;
  std::error_code error;
  if (!fs::exists(path, error)) throw FormatError(path + ": no such file");
  if (fs::is_directory(path, error)) throw FormatError(path + ": is a directory, not a file");
  if (access(path.c_str(), R_OK) != 0) throw FormatError(path + ": cannot be read: permission denied");
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) == 0) throw FormatError(path + ": is empty");
}

bool is_file(const std::string& path) {
  std::error_code error;
  return !path.empty() && path != "-" && fs::is_regular_file(path, error);
}

void check_inputs(const ChainState& chain) {
  const ChainOptions& options = chain.options;
  const StageOptions& values = chain.values;
  std::error_code ignored;
  if (options.first == ChainStage::cad2tri) require_input(options.shape);
  if (!options.nodes_file.empty() && options.nodes_file != "-" && !fs::exists(options.nodes_file, ignored))
    throw FormatError(
        fmt::format("--nodes {}: no such file; the rules are none, fewest, field and auto", options.nodes_file));
  for (const std::string& path : {values.cad2tri.names_file, values.fieldsolve.align_file, values.blocksplit.names_file,
                                  options.nodes_file, values.quadrefine.size_field_file, values.quadrefine.metric_file,
                                  values.hexsweep.curve_file, values.hexsweep.terrain_file})
    require_input(path);
  if (is_file(values.cad2tri.names_file)) boundary_names(chain);
  if (is_file(values.fieldsolve.align_file)) directions_to_align_with(chain);
  if (is_file(values.blocksplit.names_file)) block_names(chain);
  if (is_file(values.quadrefine.size_field_file)) prescribed_sizes(chain);
  if (is_file(values.quadrefine.metric_file)) prescribed_metric(chain);
  for (const std::string& path : {values.hexsweep.curve_file, values.hexsweep.terrain_file})
    if (is_file(path)) space_points(chain, path);
  if (is_file(options.nodes_file)) require_nodes(io::read_input(options.nodes_file));
}

/// Endings of the files that a stage writes, or shape_converters, cad2chart and fieldsolve for it.
std::vector<std::string> endings_of(ChainStage stage) {
  std::vector<std::string> endings{ending_of(stage)};
  if (stage == ChainStage::cad2tri) endings.insert(endings.end(), {"outline.step", "chart.h5"});
  if (stage == ChainStage::critpoints) endings.insert(endings.end(), {"phase.solve.h5", "phase.h5"});
  return endings;
}

void add_stage_files(const ChainState& chain, cli::RunFiles& files) {
  for (int i = 0; i + 1 < num_stages; ++i) {
    const auto stage = static_cast<ChainStage>(i);
    const bool keeps_nodes = stage == ChainStage::critpoints && !chain.options.nodes_file.empty();
    for (const std::string& ending : endings_of(stage)) {
      const std::string path = chain.files.stem + '.' + ending;
      if (chain.is_due(stage) && !keeps_nodes)
        files.write(path, fmt::format("the stage {}", enum_name(stage)));
      else
        files.read(path);
    }
    files.write(fmt::format("{}.before-{}.svg", chain.files.stem, enum_name(stage)), "a picture after a failure");
  }
}

/// All files that the run reads and writes, scratch files excepted.
cli::RunFiles files_of(const ChainState& chain) {
  const ChainOptions& options = chain.options;
  cli::RunFiles files;
  files.read(options.shape);
  files.read(options.nodes_file);
  for (const ShapeConverter& converter : shape_converters())
    if (const auto words = options.words.find(std::string(converter.command)); words != options.words.end())
      for (const std::string& word : words->second)
        if (is_file(word)) files.read(word);
  StageOptions values = chain.values;
  for (int i = 0; i < num_stages; ++i)
    cli::add_files([&](Options& o) { declare(o, static_cast<ChainStage>(i), values); }, files);
  if (options.last == ChainStage::quadexport) {
    const std::string output = output_of(options);
    files.write(output, "--output");
    for (const std::string& path : stage::side_paths(output, values.quadexport)) files.write(path, "--output");
  } else if (options.writes_stage_file()) {
    files.write(output_of(options), "--output");
  }
  files.write(options.report, "--report");
  files.write(options.html, "--html");
  if (!options.workdir.empty()) add_stage_files(chain, files);
  return files;
}

/// Whether the file can be written, as far as its folder tells.
void require_folder(const std::string& path) {
  if (path.empty() || path == "-") return;
  std::error_code error;  // what cannot be looked at is neither a folder nor a file
  if (fs::is_directory(path, error)) throw OutputError(path + ": cannot be written: is a directory");
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
  if (!fs::is_directory(folder, error))
    throw OutputError(fmt::format("{}: cannot be written: there is no folder {}", path, folder));
  if (!fs::exists(path, error) && access(folder.c_str(), W_OK) != 0)
    throw OutputError(path + ": cannot be written: the folder is write-protected");
}

void check_outputs(const ChainState& chain) {
  const ChainOptions& options = chain.options;
  for (const std::string& path : {options.output, options.report, chain.values.cad2tri.healed_file, options.html})
    require_folder(path);
  files_of(chain).require_distinct();
}

/// The face in the first file that this run has of it.
std::optional<CadFace> known_face(ChainState& chain) {
  if (chain.files.triangles.is_in_memory()) return chain.files.triangles.model().face;
  if (chain.options.is_dry_run && chain.options.first == ChainStage::cad2tri) return std::nullopt;
  std::string ending = "tri.h5";
  if (chain.options.first == ChainStage::blocksplit) ending = "sep.json";
  if (chain.options.first == ChainStage::quadrefine) ending = "blocks.h5";
  if (chain.options.first == ChainStage::hexsweep) ending = "quad.h5";
  if (chain.options.first == ChainStage::quadexport) ending = exported_ending(chain.options, chain.values);
  const std::string path = chain.files.stem + '.' + ending;
  if (!is_file(path)) return std::nullopt;      // with --dry-run
  if (ending == "hex.h5") return std::nullopt;  // hexahedra have none
  return io::read_face(io::read_input(path));
}

void check_face_for(ChainState& chain, ChainStage stage, const CadFace& face) {
  if (chosen_words(chain, stage).empty() && stage != ChainStage::quadexport) return;
  const cli::Outcome outcome = cli::outcome_of([&] {
    if (stage == ChainStage::critpoints) stage::require_critpoints_of(face, chain.values.critpoints);
    if (stage == ChainStage::quadrefine) {
      stage::require_quadrefine_of(face, prescribed_sizes(chain).content, prescribed_metric(chain).content,
                                   chain.values.quadrefine);
    }
    if (stage == ChainStage::quadexport && !chain.options.is_swept)
      stage::require_quadexport_of(face, output_of(chain.options), chain.values.quadexport);
  });
  if (outcome.code != ExitCode::usage && outcome.code != ExitCode::no_result) return;  // the stage says the rest
  chain.last.clear();                                                                  // no later stage has seen it
  cli::print_failure("quadmesh", outcome);
  throw ChainFailure{outcome.code, "quadmesh", outcome.message};
}

}  // namespace

void check_command_line(const ChainOptions& options, const StageOptions& values) {
  if (options.shape.empty() && options.from.empty()) throw UsageError("no shape given");
  if (!options.html.empty() && (options.html.size() < 6 || !options.html.ends_with(".html")))
    throw UsageError(fmt::format("--html: '{}' does not end in .html", options.html));
  if (options.html.empty() && !options.page_parts.empty()) throw UsageError("--html-parts needs --html FILE");
  check_range(options);
  check_skipped_options(options);
  converter_of_shape(options);
  check_stage_options(values);
  check_name_of_stage_file(options);
  check_output_format(options, values);
  check_nodes_option(options, values);
}

std::string stem_of(const std::string& shape) {
  const std::string name = shape.substr(shape.rfind('/') + 1);  // npos + 1 is 0
  return shape == "-" ? "shape" : name.substr(0, name.rfind('.'));
}

std::string exported_ending(const ChainOptions& options, const StageOptions& values) {
  if (stage::format_of(mesh_name_of(options), values.quadexport) == "step") return "blocks.h5";
  return options.is_swept ? "hex.h5" : "quad.h5";
}

std::string shape_of(const ChainOptions& options, const StageOptions& values) {
  if (!options.shape.empty() || options.first == ChainStage::cad2tri) return options.shape;
  const std::string ending = needed_endings(options, values).front();
  std::string shape;
  for (std::error_code error; const fs::directory_entry& entry : fs::directory_iterator(options.workdir, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with('.' + ending) || name.ends_with(".phase." + ending)) continue;
    if (!shape.empty())
      throw UsageError(options.workdir +
                       " has files of several shapes: name the SHAPE, of which only the name is used");
    shape = name.substr(0, name.size() - ending.size()) + "step";
  }
  if (shape.empty())
    throw UsageError(fmt::format("--from {} needs a file *.{} in {}, which has no such file", options.from, ending,
                                 options.workdir));
  return shape;
}

void check_files(const ChainState& chain) {
  require_stage_files(chain);
  check_inputs(chain);
  check_outputs(chain);
}

void check_face(ChainState& chain) {
  if (const std::optional<CadFace> face = known_face(chain))
    for (const ChainStage stage : {ChainStage::critpoints, ChainStage::quadrefine, ChainStage::quadexport})
      check_face_for(chain, stage, *face);
}

}  // namespace quadrille::chain
