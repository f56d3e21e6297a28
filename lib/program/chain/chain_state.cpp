#include "chain/chain_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/warning_codes.hpp"
#include "cli/messages.hpp"

namespace quadrille::chain {

namespace {

/// Whether quads may be found without a stage after it found no valid result or was stopped. What a user asks of the
/// quads, such as layers that do not fit, is refused.
bool may_go_on(const ChainState& chain, ChainStage stage, const StageEnd& end) {
  if (!chain.has_other_way || end.code != ExitCode::no_result) return false;
  if (end.is_stopped) return true;
  switch (stage) {
    case ChainStage::fieldsolve:
    case ChainStage::padapt:
    case ChainStage::critpoints:
    case ChainStage::separatrix:
      return true;
    case ChainStage::quadrefine:
      return chain.prefix == prefix_of_trials || io::value_of(end.report, "valid") == "false";
    default:
      return chain.prefix == prefix_of_trials;
  }
}

}  // namespace

void inform(const ChainState& chain, const std::string& text) {
  if (!chain.options.is_quiet) cli::print_message(fmt::format("quadmesh: {}\n", text));
}

/// Not that of the verdict where the line about the mesh ends with it.
void print_warnings(ChainState& chain, std::size_t first_run) {
  if (chain.options.is_quiet) return;
  const bool has_verdict = chain.options.last == ChainStage::quadexport;
  const std::vector<io::StageReport>& reports = chain.runner.reports();
  for (std::size_t i = first_run; i < reports.size(); ++i) {
    if (reports[i].stage.starts_with(prefix_of_trials)) continue;
    for (io::ReportedWarning& found : io::warnings_of(reports[i])) {
      if (has_verdict && found.code == warning::unequal_sizes) continue;
      std::replace(found.message.begin(), found.message.end(), '\n', ' ');
      const std::string text = fmt::format("warning {}: {}", found.code, found.message);
      if (chain.printed_warnings.insert(text).second) cli::print_message(fmt::format("{}: {}\n", found.tool, text));
    }
  }
}

void print_stop(const ChainState& chain) {
  if (chain.options.is_quiet) return;
  for (const io::ReportedWarning& warning : io::warnings_of(chain.given_up->report))
    cli::print_message(fmt::format("{}: warning {}: {}\n", warning.tool, warning.code, warning.message));
}

std::vector<std::string> chosen_words(const ChainState& chain, ChainStage stage) {
  if (const auto found = chain.replaced.find(enum_name(stage)); found != chain.replaced.end()) return found->second;
  std::vector<std::string> words;
  for (const Words* source : {&chain.options.words, &chain.added}) {
    const auto found = source->find(enum_name(stage));
    if (found != source->end()) words.insert(words.end(), found->second.begin(), found->second.end());
  }
  return words;
}

bool run_stage(ChainState& chain, StageTask task) {
  const ChainStage position = task.is_of_phase ? ChainStage::separatrix : task.stage;
  const bool is_trial_mesh = chain.prefix == prefix_of_trials && position == ChainStage::quadrefine;
  if (!chain.is_due(position) && !is_trial_mesh) {
    if (!is_before(chain.options.last, position)) chain.last = task.output;
    return true;
  }
  const std::string tool = enum_name(task.stage);
  task.name = chain.prefix + (task.is_of_phase ? "phase_" : "") + tool;
  const std::vector<std::string> chosen = chosen_words(chain, task.stage);
  task.words.insert(task.words.end(), chosen.begin(), chosen.end());
  if (chain.options.is_dry_run) {
    if (chain.options.writes_stage_file() && task.stage == chain.options.last && !task.is_of_phase)
      task.output = output_of(chain.options);
    std::vector<std::string> words = command_words(task, chain.options);
    words.insert(words.begin(), tool);
    cli::print_to_stdout(fmt::format("{}{}\n", chain.comment, shell_command(words)));
    chain.last = task.output;
    return true;
  }
  StageEnd end = chain.runner.run(task, chain.has_other_way ? Share::most : Share::all);
  if (!end.is_stopped) print_warnings(chain, chain.runner.reports().size() - 1);
  if (may_go_on(chain, task.stage, end)) {
    chain.given_up = std::move(end);
    return false;
  }
  if (end.code == ExitCode::done) {
    chain.last = task.output;
    return true;
  }
  if (end.is_stopped) {
    cli::print_message(fmt::format("quadmesh: {} was {}\n", tool, end.message));
    chain.last.clear();
  } else if (chain.options.is_quiet) {
    cli::print_message(end.messages);
  }
  throw ChainFailure{end.code, tool, end.message};
}

}  // namespace quadrille::chain
