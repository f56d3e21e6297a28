#include "chain/chain_inputs.hpp"

#include <fmt/format.h>

#include <optional>
#include <sstream>

#include "base/message_text.hpp"
#include "chain/end_of_run.hpp"
#include "cli/messages.hpp"
#include "io/alignment_io.hpp"
#include "io/name_rules_io.hpp"
#include "io/size_field_io.hpp"
#include "io/whole_file.hpp"
#include "triangulate/size_triangles.hpp"

namespace quadrille::chain {

namespace {

bool has_points(const ChainState& chain) {
  const std::string& shape = chain.options.shape;
  return chain.options.first == ChainStage::cad2tri &&
         (!chain.options.point_option.empty() || shape.ends_with(".dat") || shape.ends_with(".xy"));
}

/// The warnings among what points2step wrote, as the report of a stage without times.
std::string report_of_points(const std::string& messages) {
  std::istringstream lines(messages);
  const std::string start = "points2step: warning ";
  std::string warnings;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ", start.size());
    if (!line.starts_with(start) || colon == std::string::npos) continue;
    warnings +=
        fmt::format("{}{{\"code\": {}, \"message\": {}}}", warnings.empty() ? "" : ", ",
                    json_string(line.substr(start.size(), colon - start.size())), json_string(line.substr(colon + 2)));
  }
  return warnings.empty() ? std::string() : fmt::format("{{\"tool\": \"points2step\", \"warnings\": [{}]}}", warnings);
}

/// Prints what it tells about the points.
void print_notes(const std::string& messages) {
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("points2step: warning ")) fmt::print(stderr, "{}\n", line);
}

/// Messages of points2step about its options are about those of quadmesh.
std::string with_own_name(std::string text) {
  for (const auto& [from, to] : {std::pair{"points2step: ", "quadmesh: "}, {"points2step --help", "quadmesh --help"}})
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += std::string(to).size())
      text.replace(at, std::string(from).size(), to);
  return text;
}

/// The shape as a CAD file. Throws ChainFailure.
std::string cad_file(ChainState& chain) {
  if (!has_points(chain)) return chain.options.shape;
  std::string made = chain.files.stem + ".outline.step";
  std::string shape = chain.options.shape;
  if (shape == "-" && chain.standard_input) {
    shape = chain.runner.scratch() + "/points";
    io::write_output(shape, *chain.standard_input, true, io::Lasting::for_the_run);
  }
  std::vector<std::string> words{"points2step", shape, "-o", made};
  if (const auto chosen = chain.options.words.find("points2step"); chosen != chain.options.words.end())
    words.insert(words.end(), chosen->second.begin(), chosen->second.end());
  if (chain.options.is_dry_run) {
    cli::print_to_stdout(shell_command(words) + '\n');
    return made;
  }
  words.front() = command_path("points2step");
  const auto [code, messages] = chain.runner.run_helper(words);
  if (code != 0) {
    cli::print_message(with_own_name(messages));
    const std::string line = messages.substr(0, messages.find('\n'));
    const bool is_own = line.starts_with("points2step: ") || line.starts_with("quadmesh: ");
    throw ChainFailure{static_cast<ExitCode>(code), "points2step", is_own ? line.substr(line.find(": ") + 2) : line};
  }
  if (std::string report = report_of_points(messages); !report.empty()) {
    chain.runner.reports().push_back({"points2step", std::move(report)});
    print_warnings(chain, 0);
  }
  if (!chain.options.is_quiet) print_notes(messages);
  return made;
}

}  // namespace

void triangulate_shape(ChainState& chain) {
  const std::string path = chain.is_due(ChainStage::cad2tri) ? cad_file(chain) : chain.options.shape;
  const auto triangles = [&](Run& run) {
    const io::InputFile file = read_input(chain, path);
    const Names names = boundary_names(chain);
    stage::Cad2triInput input{{file.bytes, file}, {}};
    std::optional<ChartedFace> chart;
    if (io::is_chart(file)) input.chart.emplace(chart.emplace(io::read_stage<ChartedFace>(file)), file);
    if (names.file) input.names.emplace(names.content, *names.file);
    const stage::Cad2triOptions& options = chain.values.cad2tri;
    const stage::LoadedShape shape = stage::load_shape(input, options, run);
    if (!options.healed_file.empty())
      io::write_output(options.healed_file, stage::cad_file_of(shape.face, options.healed_file), false);
    return stage::cad2tri(shape, options, run);
  };
  make_file(chain, {ChainStage::cad2tri, false, {path}}, chain.files.triangles, triangles);
}

namespace fs = std::filesystem;

io::InputFile read_input(const ChainState& chain, const std::string& path) {
  if (path != "-" || !chain.standard_input) return io::read_input(path);
  io::InputFile file{io::identity_of("standard input", *chain.standard_input), *chain.standard_input};
  if (file.bytes.empty()) throw FormatError("standard input: is empty");
  return file;
}

Names boundary_names(const ChainState& chain) {
  if (chain.values.cad2tri.names_file.empty()) return {};
  const io::InputFile file = read_input(chain, chain.values.cad2tri.names_file);
  return {io::read_boundary_names(file), file};
}

Names block_names(const ChainState& chain) {
  if (chain.values.blocksplit.names_file.empty()) return {};
  const io::InputFile file = read_input(chain, chain.values.blocksplit.names_file);
  return {io::read_block_names(file), file};
}

PrescribedSizes prescribed_sizes(const ChainState& chain, const CadFace& face) {
  if (chain.values.quadrefine.size_field_file.empty()) return {};
  const io::InputFile file = read_input(chain, chain.values.quadrefine.size_field_file);
  PrescribedSizes sizes{io::read_size_field(file, face.origin), file};
  if (sizes.content.is_table) triangulate::add_size_triangles(sizes.content);
  return sizes;
}

Directions directions_to_align_with(const ChainState& chain, const CadFace& face) {
  if (chain.values.fieldsolve.align_file.empty()) return {};
  const io::InputFile file = read_input(chain, chain.values.fieldsolve.align_file);
  return {io::read_alignment(file, face.origin, stage::usual_feature_width(face)), file};
}

}  // namespace quadrille::chain
