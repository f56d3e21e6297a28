#include "cli/tool_main.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <optional>

#include "base/cleanup.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/version.hpp"
#include "cli/command_line.hpp"
#include "cli/messages.hpp"
#include "cli/outcome.hpp"
#include "cli/process_setup.hpp"

namespace quadrille::cli {

namespace {

void write_report_of(const Tool& tool, Session& session, const Outcome& outcome, const std::string& path) {
  if (path.empty() || !tool.report_writer) return;
  session.report().set("exit_code", static_cast<int>(outcome.code));
  if (outcome.code != ExitCode::done) session.report().set("error", outcome.message);
  tool.report_writer(path, tool.name, version, session.report());
}

/// How --progress asks for it; std::nullopt: not at all.
std::optional<ProgressStyle> progress_style(const Tool& tool, const CommonOptions& common, bool writes_to_stdout) {
  const bool is_always = common.progress == "always", is_terminal = isatty(STDERR_FILENO) == 1;
  if (!is_always && !(common.progress == "auto" && common.verbosity >= 0 && is_terminal)) return std::nullopt;
  ProgressStyle style;
  style.is_terminal = is_terminal;
  style.title = tool.name;
  if (is_always)
    style.delay = 0;
  else
    style.hidden_phases.emplace_back("read");  // in a pipeline, tools wait there for their input
  if (is_terminal && writes_to_stdout && isatty(STDOUT_FILENO) == 1) style.hidden_phases.emplace_back("write");
  return style;
}

void require_distinct_files(const Tool& tool, const CommandLine& line) {
  RunFiles files;
  line.add_files(files);
  files.require_distinct();
  if (!tool.files) return;
  tool.files(files);
  files.require_distinct();
}

/// Runs the tool; the report is written in any case.
Outcome run_session(const Tool& tool, Session& session, const CommonOptions& common) {
  Outcome outcome = outcome_of([&] { tool.run(session); });
  session.finish();
  if (outcome.code != ExitCode::done) remove_temporaries();
  if (common.verbosity >= 0)
    for (const auto& [code, message] : session.report().warnings())
      print_message(fmt::format("{}: warning {}: {}\n", tool.name, code, message));
  Outcome reporting = outcome_of([&] { write_report_of(tool, session, outcome, common.report); });
  if (outcome.code == ExitCode::done) return reporting;
  print_failure(tool.name, reporting);
  return outcome;
}

/// Answers a question about the tool, or runs it. Throws where the command line has a fault.
Outcome run_tool(int argc, char** argv, const Tool& tool) {
  CommonOptions common;
  CommandLine line(HelpPage{tool.name, tool.summary, tool.description, {}, tool.examples, {}, {}, {}});
  const Request request = request_of({argv + 1, argv + argc});
  if (tool.options) tool.options(line);
  line.add_common(common);
  answer(
      request, tool.name, [&] { return help_text(line.page()); }, [&] { return line.option_list(); });
  if (request != Request::run) return {};
  line.parse(argc, argv);
  require_distinct_files(tool, line);
  if (common.threads == 0) start_threads_after();  // with --threads N they start at once
  Session session(tool.name, line.options_json(), common.verbosity, common.threads);
  if (const auto style = progress_style(tool, common, line.writes_to_stdout())) session.show_progress(*style);
  return run_session(tool, session, common);
}

}  // namespace

int tool_main(int argc, char** argv, const Tool& tool) {
  occupy_standard_streams();
  set_up_heap();
  install_signal_handlers();
  Outcome outcome;
  const Outcome beginning = outcome_of([&] { outcome = run_tool(argc, argv, tool); });
  return print_failure(tool.name, beginning.is_success() ? outcome : beginning);
}

}  // namespace quadrille::cli
