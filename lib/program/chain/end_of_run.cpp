#include "chain/end_of_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/version.hpp"
#include "cli/messages.hpp"
#include "cli/outcome.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

namespace {

namespace fs = std::filesystem;

io::ChainFacts facts_of(const ChainState& chain) {
  io::ChainFacts facts;
  if (chain.form) facts.form = enum_name(*chain.form);
  facts.num_nodes = chain.num_nodes;
  facts.remedy = chain.remedy;
  facts.trials = chain.trials;
  facts.version = version;
  facts.wall_seconds = chain.runner.seconds();
  return facts;
}

/// The ending of the file of each PagePart.
constexpr std::array page_endings{"tri.h5",   "field.h5",  "crit.json", "phase.h5",
                                  "sep.json", "blocks.h5", "quad.h5",   "hex.h5"};

/// The files of the parts that the page shows; what an earlier run left in the folder is older than the triangles.
std::vector<std::string> files_of_page(const ChainState& chain) {
  const std::vector<PagePart>& parts = chain.options.page_parts;
  const std::string triangles = chain.files.triangles.path();
  const fs::file_time_type begin = fs::last_write_time(triangles);
  std::vector<std::string> files;
  for (std::size_t k = 0; k < page_endings.size(); ++k) {
    if (!parts.empty() && std::ranges::find(parts, static_cast<PagePart>(k)) == parts.end()) continue;
    const bool is_first = static_cast<PagePart>(k) == PagePart::triangles;
    const std::string path = is_first ? triangles : chain.files.stem + '.' + page_endings[k];
    std::error_code error;
    const fs::file_time_type time = fs::last_write_time(path, error);
    if (is_first || (!error && time > begin)) files.push_back(path);
  }
  return files;
}

/// A tab for each part that was made, and one with the report.
void write_page(ChainState& chain, const io::ChainReport& report) {
  const std::string run_report = chain.runner.scratch() + "/run.json";
  io::write_output(run_report, report.text_with_command(chain.options.typed), false, io::Lasting::for_the_run);
  const std::vector<std::string> files = files_of_page(chain);
  if (files.empty()) {
    cli::print_message("quadmesh: --html-parts: this run makes none of the parts: name others\n");
    throw ChainFailure{ExitCode::usage, "stageview", {}};
  }
  std::vector<std::string> words{command_path("stageview"), "-q"};
  words.insert(words.end(), files.begin(), files.end());
  words.insert(words.end(), {"--run-report", run_report, "-o", chain.options.html});
  const auto [code, messages] = chain.runner.run_helper(words);
  cli::print_message(messages);
  if (code != 0) throw ChainFailure{static_cast<ExitCode>(code), "stageview", {}};
}

void print_summary(const ChainState& chain, const io::ChainReport& report) {
  const ChainOptions& options = chain.options;
  const bool ends_early = options.last != ChainStage::quadexport;
  if (options.is_quiet) return;
  const bool has_output = !ends_early || options.writes_stage_file();
  const bool uses_stdout = options.report == "-" || (has_output && output_of(options) == "-");
  const int stream = uses_stdout ? STDERR_FILENO : STDOUT_FILENO;
  if (options.is_verbose) cli::print_message(report.times(), stream);
  const bool has_mesh = !is_before(options.last, ChainStage::quadrefine) && has_output;
  const std::string output = output_of(options) == "-" ? "standard output" : output_of(options);
  const std::string file = has_output ? output : chain.last;
  const std::string result = has_mesh ? report.summary() : fmt::format("stages up to {}: {}", options.until, file);
  cli::print_message(result + '\n', stream);
}

/// Where to look after a stage failed.
void show_last_file(ChainState& chain, const std::string& stage) {
  if (chain.options.workdir.empty()) {
    cli::print_message(fmt::format(
        "quadmesh: run it again with --workdir DIR to keep the files of the stages before {} and a picture\n", stage));
    return;
  }
  const std::string picture = fmt::format("{}.before-{}.svg", chain.files.stem, stage);
  std::vector<std::string> words{command_path("stageview"), chain.last, "-o", picture};
  if (chain.last.ends_with(".crit.json")) words.insert(words.end(), {"--field", chain.files.field.path()});
  if (chain.runner.run_helper(words).first != 0) return;
  cli::print_message(
      fmt::format("quadmesh: the files of the stages before {} are kept in {}; look at the last one with\n", stage,
                  chain.options.workdir));
  cli::print_message(fmt::format("  xdg-open '{}'\n", picture));
}

}  // namespace

void end_run(ChainState& chain) {
  const io::ChainReport report(chain.runner.reports(), facts_of(chain));
  if (!chain.options.html.empty()) write_page(chain, report);
  if (!chain.options.report.empty()) io::write_output(chain.options.report, report.text(), false);
  print_summary(chain, report);
}

void end_failed_run(ChainState& chain, const ChainFailure& failure) {
  if (!chain.options.report.empty() && !chain.options.is_dry_run) {
    io::ChainFacts facts = facts_of(chain);
    facts.exit_code = static_cast<int>(failure.code);
    facts.failed_stage = failure.stage;
    facts.error = failure.message;
    const cli::Outcome written = cli::outcome_of(
        [&] { io::write_output(chain.options.report, io::ChainReport(chain.runner.reports(), facts).text(), false); });
    // Of several outputs that cannot be written, one is told of; it may be the report.
    if (failure.code != ExitCode::bad_output) cli::print_failure("quadmesh", written);
  }
  const bool may_be_the_shape = failure.code == ExitCode::no_result || failure.code == ExitCode::defect;
  if (may_be_the_shape && !chain.last.empty()) show_last_file(chain, failure.stage);
}

std::string command_path(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& path : {folder / name, folder / "../../pipelines" / name})
    if (fs::exists(path, error)) return path.string();
  return name;
}

}  // namespace quadrille::chain
