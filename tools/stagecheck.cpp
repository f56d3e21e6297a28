// stagecheck: checks a stage file against the rules of its format page. Exit 0, or 3 with every broken rule.

#include <fmt/format.h>

#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "check/check.hpp"
#include "cli/tool_main.hpp"
#include "io/format_list.hpp"
#include "io/history.hpp"
#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "io/stage_files.hpp"

using namespace quadrille;

namespace {

/// A mesh may satisfy all rules without being valid: then it is marked as not valid.
void warn_of_validity(const StageModel& stage, const std::string& file, cli::Session& session) {
  const QuadMesh* mesh = std::get_if<QuadMesh>(&stage);
  if (mesh && !mesh->is_valid)
    session.report().warn(warning::mesh_not_valid, fmt::format("{}: {}", file, check::validity_warning(*mesh)));
}

/// Prints the violations of one file and returns their number.
std::size_t check_file(const std::string& path, cli::Session& session) {
  try {
    const io::InputFile file = io::read_input(path);
    session.begin_phase("check");
    const StageModel stage = io::read_any_stage(file);
    const std::vector<check::Violation> violations =
        std::visit([](const auto& model) { return check::check_stage(model, check::CheckDepth::full); }, stage);
    if (violations.empty()) warn_of_validity(stage, file.name, session);
    session.end_phase();
    for (const check::Violation& violation : violations)
      fmt::print("{}: {}: {}\n", file.name, violation.rule, violation.text);
    session.info(fmt::format("{}: {}, {}", file.name, stage_formats[stage.index()].name,
                             violations.empty() ? "all rules hold" : counted(violations.size(), "violation")));
    return violations.size();
  } catch (const FormatError& e) {
    session.end_phase();
    fmt::print("{}\n", e.what());  // the message contains the file name
    return 1;
  }
}

Provenance provenance_of(const io::InputFile& file) {
  return std::visit([](const auto& model) { return model.provenance; }, io::read_any_stage(file));
}

/// Prints the commands by which the files were made, each once.
void print_history(const std::vector<std::string>& paths) {
  std::vector<io::MadeFile> files;
  for (const std::string& path : paths) {
    const io::InputFile file = io::read_input(path);
    files.push_back({path, file.sha256, provenance_of(file)});
  }
  io::History history;
  for (const io::MadeFile& file : io::oldest_first(std::move(files))) {
    for (const std::string& line : history.lines_of(file.chain, file.sha256, io::history_stem(file.path)))
      fmt::print("{}\n", line);
    if (!file.chain.empty() && file.chain.back().tool == "critpoints")
      fmt::print("# {}: SHA-256 {}; if the command makes another file, it was edited since: use the edited one\n",
                 history.name_of(file.sha256), file.sha256);
  }
}

void check_files(const std::vector<std::string>& paths, cli::Session& session) {
  std::size_t num_violations = 0, num_bad = 0;
  for (const std::string& path : paths) {
    const std::size_t found = check_file(path, session);
    num_violations += found;
    num_bad += found > 0 ? 1 : 0;
  }
  session.report().set("files", paths.size());
  session.report().set("violations", num_violations);
  if (num_bad > 0)
    throw FormatError(
        fmt::format("{} of {} {} broken", num_bad, counted(paths.size(), "file"), num_bad == 1 ? "is" : "are"));
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> paths;
  bool is_history = false, is_list = false;
  cli::Tool tool;
  tool.name = "stagecheck";
  tool.summary = "checks stage files against the numbered rules of their formats";
  tool.description =
      "Reads each FILE (tri-mesh, field, critical-points, separatrix-graph, block-layout or quad-mesh), checks every "
      "rule of its format page in formats/, including proofs of positive Jacobians, and prints one line for each "
      "violation: FILE: RULE: text. Nothing is printed if all rules hold; -v reports what was checked. --history "
      "prints how the files were made instead.";
  tool.examples = {"stagecheck half_disc.tri.h5", "stagecheck -v half_disc.crit.json half_disc.quad.h5",
                   "stagecheck --history half_disc.crit.json half_disc.quad.h5"};
  tool.options = [&](Options& options) {
    options.inputs("FILE", paths, "stage files to check");
    options.flag("--history", is_history,
                 "print the commands by which each FILE was made, with all options, from its provenance, each "
                 "command once; inputs that no command makes are described by their "
                 "SHA-256. Give x.crit.json with the files made from it: only it knows the options of critpoints");
    options.flag(
        "--list-formats", is_list,
        "print the formats with their versions, and the tools that write them, as JSON for scripts; no FILE is "
        "read");
  };
  tool.run = [&](cli::Session& session) {
    if (is_list)
      fmt::print("{}", io::format_list());
    else if (is_history)
      print_history(paths);
    else
      check_files(paths, session);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
