#include "chain/stage_runner.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "base/child_process.hpp"
#include "base/cleanup.hpp"
#include "base/message_text.hpp"
#include "base/parallel.hpp"
#include "base/version.hpp"
#include "base/warning_codes.hpp"
#include "chain/watched_child.hpp"
#include "cli/messages.hpp"
#include "cli/outcome.hpp"
#include "cli/session.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

namespace {

/// The system kills a process at the hard limit of its CPU time too.
std::string cause_of_kill() {
  rlimit seconds{};
  const bool is_limited = getrlimit(RLIMIT_CPU, &seconds) == 0 && seconds.rlim_max != RLIM_INFINITY;
  return is_limited ? fmt::format("after {} s of CPU time (ulimit -t) or when memory runs out", seconds.rlim_max)
                    : "when memory runs out";
}

/// How many stages follow a run, if nothing unforeseen happens.
int stages_after(const StageTask& task, const ChainOptions& options) {
  // fieldsolve and padapt of a phase run before separatrix.
  const auto position = static_cast<int>(task.is_of_phase ? ChainStage::critpoints : task.stage);
  int count = task.is_of_phase && task.stage == ChainStage::fieldsolve ? 1 : 0;
  for (int i = position + 1; i < num_stages; ++i) count += options.runs(static_cast<ChainStage>(i));
  return count;
}

/// What a stage did not report itself. `warnings`: JSON objects, joined by commas.
std::string report_of(const std::string& tool, int code, const std::string& error, const ChildEnd& end,
                      const std::string& warnings = {}) {
  return fmt::format(
      R"({{"tool": {}, "exit_code": {}, "error": {}, "timings": {{"total": {{"cpu_seconds": {}, "wall_seconds": {}}}}}, )"
      R"("warnings": [{}]}})",
      json_string(tool), code, json_string(error), end.cpu_seconds, end.wall_seconds, warnings);
}

/// The warning holds if there are quads without a field.
std::string report_of_stopped(const std::string& tool, const std::string& reason, const ChildEnd& end) {
  const std::string text = fmt::format("{} was {}: the quads are made without a field", tool, reason);
  return report_of(
      tool, 1, reason, end,
      fmt::format(R"({{"tool": "quadmesh", "code": "{}", "message": {}}})", warning::stage_stopped, json_string(text)));
}

/// A mistake on the command line is one of quadmesh: what is wrong with its options, or begins with one.
std::string messages_of(const std::string& tool, const cli::Outcome& outcome) {
  if (outcome.is_success()) return {};
  const bool is_of_user = outcome.code == ExitCode::usage || outcome.message.starts_with("--");
  return cli::error_text(is_of_user ? "quadmesh" : tool, outcome);
}

/// The report that a process wrote before it ended; empty if it wrote no report.
std::string report_in(const std::string& path) {
  return std::filesystem::exists(path) && !std::filesystem::is_empty(path) ? io::read_input(path).bytes : std::string();
}

/// Refuses what exceeds the limit faster than the parent process looks. Data that are reserved count, those of the
/// stacks of threads too.
void limit_own_memory(const Budget& budget, int num_threads) {
  constexpr double most_excess = 0.08;  // of what is allowed
  constexpr std::size_t stack = 1 << 20;
  if (!budget.limits().memory) return;
  const auto most = static_cast<std::size_t>((1 + most_excess) * static_cast<double>(*budget.limits().memory));
  const std::size_t of_files = memory_use().of_files, num_stacks = static_cast<std::size_t>(num_threads) - 1;
  limit_stacks(stack);
  limit_data(most - std::min<std::size_t>(most, of_files) + num_stacks * stack);
}

/// What the chart of a curved face took in the run of its triangles.
Used used_for_chart(const io::StageReport& report) {
  const auto seconds = [&](const std::string& clock) {
    const std::optional<std::string> text = io::value_of(report, "timings.chart." + clock);
    return text ? std::stod(*text) : 0.0;
  };
  return {seconds("cpu_seconds"), seconds("wall_seconds")};
}

}  // namespace

std::vector<std::string> command_words(const StageTask& task, const ChainOptions& options) {
  std::vector<std::string> words = task.words;
  words.insert(words.end(), {"-o", task.output});
  if (!options.threads.empty()) words.insert(words.end(), {"--threads", options.threads});
  if (options.is_quiet) words.emplace_back("-q");
  return words;
}

StageRunner::StageRunner(const ChainOptions& options, Budget budget, bool in_children, std::string scratch)
    : options_(options), budget_(std::move(budget)), in_children_(in_children), scratch_(std::move(scratch)) {}

double StageRunner::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool StageRunner::is_in_child(ChainStage stage) const { return in_children_ || options_.programs.contains(stage); }

std::string StageRunner::progress_title(const StageTask& task) const {
  const int number = static_cast<int>(reports_.size()) + 1;
  return fmt::format("quadmesh: stage {} of {}, {}", number, number + stages_after(task, options_),
                     enum_name(task.stage));
}

StageEnd StageRunner::run(const StageTask& task, Share share) {
  StageEnd end = is_in_child(task.stage) ? run_in_child(task, share) : run_here(task);
  reports_.push_back(end.report);
  if (!options_.is_quiet) print_messages(end);
  return end;
}

void StageRunner::print_messages(const StageEnd& end) const { cli::print_message(end.messages); }

StageEnd StageRunner::run_here(const StageTask& task) {
  const std::string tool = enum_name(task.stage);
  cli::Session session(tool, "{}", options_.is_quiet ? -1 : 0, options_.num_threads);
  session.leave_out_earlier_work();
  if (!options_.is_quiet && isatty(STDERR_FILENO) == 1) {
    cli::ProgressStyle style;
    style.is_terminal = true;
    style.title = progress_title(task);
    style.seconds_before = seconds();
    session.show_progress(style);
  }
  const cli::Outcome outcome = cli::outcome_of([&] { task.compute(session); });
  session.finish();
  if (!outcome.is_success()) remove_temporaries();
  session.report().set("exit_code", static_cast<int>(outcome.code));
  if (!outcome.is_success()) session.report().set("error", outcome.message);
  return {outcome.code,
          outcome.message,
          messages_of(tool, outcome),
          false,
          {task.name, io::report_text(tool, version, session.report())},
          outcome.lacks_memory};
}

std::vector<std::string> StageRunner::command_of(const StageTask& task, const std::string& report) const {
  std::vector<std::string> words{"/bin/sh", "-c", options_.programs.at(task.stage) + " \"$@\"", enum_name(task.stage)};
  const std::vector<std::string> own = command_words(task, options_);
  words.insert(words.end(), own.begin(), own.end());
  words.insert(words.end(), {"--report", report});
  if (!options_.is_quiet) words.emplace_back("-q");  // warnings are printed from its report
  return words;
}

ChildEnd StageRunner::child_of(const StageTask& task, const std::string& report, Share share, std::string& errors) {
  if (options_.programs.contains(task.stage)) {
    task.write_inputs();
    return run_command(command_of(task, report), {STDIN_FILENO, &errors}, budget_, share);
  }
  const auto body = [&] {
    limit_own_memory(budget_, options_.num_threads > 0 ? options_.num_threads : available_processors());
    const StageEnd end = run_here(task);
    if (end.lacks_memory && budget_.limits().memory) return stopped_code;
    io::write_output(report, end.report.json, false, io::Lasting::for_the_run);
    return static_cast<int>(end.code);
  };
  return run_child(body, budget_, share);
}

StageEnd StageRunner::run_in_child(const StageTask& task, Share share) {
  constexpr int of_signal = 128, killed = of_signal + 9;
  const std::string tool = enum_name(task.stage), report = fmt::format("{}/{}.json", scratch_, reports_.size());
  StageEnd end;
  ChildEnd child = child_of(task, report, share, end.messages);
  task.drop_result();
  if (!child.stopped && child.code == stopped_code && !options_.programs.contains(task.stage))
    child.stopped = budget_.reason_of_memory(child.memory);
  if (!child.stopped && child.code == killed) child.stopped = "killed by signal 9, as systems do " + cause_of_kill();
  if (child.stopped)
    return {ExitCode::no_result, *child.stopped, {}, true, {task.name, report_of_stopped(tool, *child.stopped, child)}};
  end.code = static_cast<ExitCode>(child.code);
  end.report = {task.name, report_in(report)};
  budget_.move_to_helper(used_for_chart(end.report));
  end.message = io::value_of(end.report, "error").value_or("");
  if (child.code > of_signal) end.message = fmt::format("ended by signal {}", child.code - of_signal);
  if (child.code != 0 && !io::value_of(end.report, "tool")) {
    if (end.message.empty()) end.message = fmt::format("ended with the exit code {}", child.code);
    end.report.json = report_of(tool, child.code, end.message, child);
  }
  if (end.messages.empty()) end.messages = messages_of(tool, {end.code, end.message});
  return end;
}

std::pair<int, std::string> StageRunner::run_helper(const std::vector<std::string>& words) {
  std::string errors;
  Budget of_helper = budget_;
  const ChildEnd end = run_command(words, {STDIN_FILENO, &errors}, of_helper, Share::all);
  budget_.add_helper({end.cpu_seconds, end.wall_seconds});
  if (!end.stopped) return {end.code, errors};
  const std::string name = std::filesystem::path(words.front()).filename().string();
  return {static_cast<int>(ExitCode::no_result), fmt::format("quadmesh: {} was {}\n", name, *end.stopped)};
}

}  // namespace quadrille::chain
