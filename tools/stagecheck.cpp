// stagecheck: checks a stage file against the rules of its format page. Exit 0, or 3 with every broken rule.

#include "stage/stagecheck.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "cli/messages.hpp"
#include "cli/tool_main.hpp"
#include "io/stage_files.hpp"

using namespace quadrille;

namespace {

/// Prints the violations of one file and returns their number.
std::size_t check_file(const std::string& path, cli::Session& session) {
  try {
    const io::InputFile file = io::read_input(path);
    session.begin_phase("check");
    const StageModel stage = io::read_any_stage(file);
    const std::vector<std::string> lines = stage::stagecheck(stage, file.name, session);
    session.end_phase();
    for (const std::string& line : lines) cli::print_to_stdout(line + '\n');
    session.info(fmt::format("{}: {}, {}", file.name, stage_formats[stage.index()].name,
                             lines.empty() ? "all rules hold" : counted(lines.size(), "violation")));
    return lines.size();
  } catch (const FormatError& e) {
    session.end_phase();
    cli::print_to_stdout(std::string(e.what()) + '\n');  // the message contains the file name
    return 1;
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

void print_history(const std::vector<std::string>& paths) {
  std::vector<io::MadeFile> files;
  for (const std::string& path : paths) {
    const io::InputFile file = io::read_input(path);
    files.push_back({path, file.sha256, provenance_of(io::read_any_stage(file))});
  }
  for (const std::string& line : stage::history_lines(std::move(files))) cli::print_to_stdout(line + '\n');
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> paths;
  stage::StagecheckOptions options;
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
  tool.options = [&](Options& o) {
    o.inputs("FILE", paths, "stage files to check");
    declare(o, options);
  };
  tool.run = [&](cli::Session& session) {
    if (options.is_list)
      cli::print_to_stdout(stage::format_list());
    else if (options.is_history)
      print_history(paths);
    else
      check_files(paths, session);
  };
  tool.report_writer = io::write_report;
  return cli::tool_main(argc, argv, tool);
}
