#include "chain/chain_inputs.hpp"

#include <optional>
#include <variant>

#include "cad/load_face.hpp"
#include "chain/end_of_run.hpp"
#include "chain/shape_converters.hpp"
#include "cli/messages.hpp"
#include "cli/outcome.hpp"
#include "io/alignment_io.hpp"
#include "io/name_rules_io.hpp"
#include "io/point_table.hpp"
#include "io/size_field_io.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

namespace {

bool is_curved(const ChainState& chain, const std::string& path) {
  const io::InputFile file = read_input(chain, path);
  if (io::is_chart(file) || !chain.values.cad2tri.section.empty()) return false;
  return cad::face_kind_guarded(file.bytes, file.name, chain.values.cad2tri.face) != "plane";
}

/// The options of cad2chart, which those of cad2tri name.
stage::Cad2chartOptions chart_options(const stage::Cad2triOptions& options) {
  stage::Cad2chartOptions result;
  result.face = options.face;
  result.corner_angle = options.corner_angle, result.heal_tolerance = options.heal_tolerance;
  return result;
}

/// What cad2tri is told about the chart: the face and its healing are for cad2chart.
stage::Cad2triOptions options_in_chart(stage::Cad2triOptions options) {
  const stage::Cad2triOptions defaults;
  options.face.clear();
  options.heal_tolerance = defaults.heal_tolerance;
  return options;
}

/// The chart as its file is, or would be.
io::InputFile chart_file(const ChainState& chain, const SpaceFace& face, const io::InputFile& shape, Run& run) {
  stage::require_format_in_space(stage::format_of(mesh_name_of(chain.options), chain.values.quadexport));
  const std::string path = chain.files.stem + ".chart.h5";
  std::string bytes =
      io::stage_bytes(stage::cad2chart(face, {shape.bytes, shape}, chart_options(chain.values.cad2tri), run));
  if (chain.keeps_files) io::write_stage_bytes(path, bytes, io::Lasting::for_the_run);
  const FileIdentity identity = io::identity_of(path, bytes);
  return {identity, std::move(bytes)};
}

/// For a program in place of cad2tri, which reads the chart from its file. Throws ChainFailure.
void run_cad2chart(ChainState& chain, std::vector<std::string> words) {
  words.front() = command_path(words.front());
  const auto [code, messages] = chain.runner.run_helper(words);
  if (code == 0) return;
  cli::print_message(messages);
  throw ChainFailure{static_cast<ExitCode>(code), "cad2chart", messages.substr(0, messages.find('\n'))};
}

/// Moves the words of cad2chart from cad2tri to it, and prints its command in a dry run.
std::string move_words_to_chart(ChainState& chain, const std::string& shape, const std::string& chart) {
  std::vector<std::string> of_chart{"cad2chart", shape}, rest;
  const std::vector<std::string> words = chosen_words(chain, ChainStage::cad2tri);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_of_chart = (words[i] == "--face" || words[i] == "--heal-tolerance") && i + 1 < words.size();
    std::vector<std::string>& target = is_of_chart ? of_chart : rest;
    target.push_back(words[i]);
    if (is_of_chart) target.push_back(words[++i]);
  }
  of_chart.insert(of_chart.end(), {"-o", chart});
  if (chain.options.is_dry_run)
    cli::print_to_stdout(shell_command(of_chart) + '\n');
  else if (chain.options.programs.contains(ChainStage::cad2tri))
    run_cad2chart(chain, of_chart);
  chain.replaced["cad2tri"] = rest;
  return chart;
}

}  // namespace

namespace {

/// The face of the CAD file, planar or curved: the file is read once.
TriMesh triangles_of(const ChainState& chain, const std::string& shape, Run& run) {
  io::InputFile file = read_input(chain, shape);
  stage::Cad2triOptions options = chain.values.cad2tri;
  std::optional<cad::LoadedFace> face;
  if (!io::is_chart(file)) {
    cad::AnyFace any = stage::read_any_face({file.bytes, file}, options, run);
    if (auto* const curved = std::get_if<SpaceFace>(&any)) {
      file = chart_file(chain, *curved, file, run);
      options = options_in_chart(options);
    } else {
      face = std::get<cad::LoadedFace>(std::move(any));
    }
  }
  const auto names = boundary_names(chain);
  stage::Cad2triInput input{{file.bytes, file}, names.input(), {}, std::move(face)};
  std::optional<ChartedFace> chart;
  if (io::is_chart(file)) input.chart.emplace(chart.emplace(io::read_stage<ChartedFace>(file)), file);
  const stage::LoadedShape loaded = stage::load_shape(input, options, run);
  if (!options.healed_file.empty())
    io::write_output(options.healed_file, stage::cad_file_of(loaded.face, options.healed_file), false);
  return stage::cad2tri(loaded, options, run);
}

/// Whether cad2tri is only printed as a command, or run as one, which needs to know whether cad2chart comes before.
bool needs_command(const ChainState& chain) {
  return chain.is_due(ChainStage::cad2tri) &&
         (chain.options.is_dry_run || chain.options.programs.contains(ChainStage::cad2tri));
}

}  // namespace

void triangulate_shape(ChainState& chain) {
  const std::string shape = chain.is_due(ChainStage::cad2tri) ? cad_file(chain) : chain.options.shape;
  std::string path = shape;
  bool has_chart = false;
  if (needs_command(chain))
    cli::outcome_of([&] { has_chart = is_curved(chain, shape); });  // cad2tri says what is wrong
  if (has_chart) path = move_words_to_chart(chain, shape, chain.files.stem + ".chart.h5");
  make_file(chain, {ChainStage::cad2tri, false, {path}}, chain.files.triangles,
            [&](Run& run) { return triangles_of(chain, shape, run); });
}

namespace fs = std::filesystem;

io::InputFile read_input(const ChainState& chain, const std::string& path) {
  if (path != "-" || !chain.standard_input) return io::read_input(path);
  io::InputFile file{io::identity_of("standard input", *chain.standard_input), *chain.standard_input};
  if (file.bytes.empty()) throw FormatError("standard input: is empty");
  return file;
}

namespace {

template <typename Read>
auto prescribed(const ChainState& chain, const std::string& path, const Read& read) {
  return stage::prescribed(
      path, [&](const std::string& name) { return read_input(chain, name); }, read);
}

}  // namespace

stage::Prescribed<std::vector<NameRule>> boundary_names(const ChainState& chain) {
  return prescribed(chain, chain.values.cad2tri.names_file, io::read_boundary_names);
}

stage::Prescribed<std::vector<NameRule>> block_names(const ChainState& chain) {
  return prescribed(chain, chain.values.blocksplit.names_file, io::read_block_names);
}

stage::Prescribed<SizeSources> prescribed_sizes(const ChainState& chain) {
  return prescribed(chain, chain.values.quadrefine.size_field_file, io::read_size_field);
}

stage::Prescribed<GivenMetric> prescribed_metric(const ChainState& chain) {
  return prescribed(chain, chain.values.quadrefine.metric_file, io::read_metric);
}

stage::Prescribed<stage::PointList> space_points(const ChainState& chain, const std::string& path) {
  return prescribed(chain, path, io::space_points);
}

stage::Prescribed<GivenAlignment> directions_to_align_with(const ChainState& chain) {
  return prescribed(chain, chain.values.fieldsolve.align_file, io::read_alignment);
}

}  // namespace quadrille::chain
