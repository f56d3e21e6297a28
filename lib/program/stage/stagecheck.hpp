#pragma once
// The command stagecheck: checks a stage file against the rules of its format page, or lists the commands that made it.

#include <optional>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "io/history.hpp"
#include "model/stage_formats.hpp"

namespace quadrille::stage {

struct StagecheckOptions {
  bool is_history = false, is_list = false;
};
void declare(Options& options, StagecheckOptions& stagecheck);

/// Lines "FILE: RULE: text", one for each violation. A mesh that satisfies all rules but is marked as not valid is
/// reported.
std::vector<std::string> stagecheck(const StageModel& stage, const std::string& file, Run& run);

/// The commands by which the files were made, each once, with the digests of what only a person can have made.
std::vector<std::string> history_lines(std::vector<io::MadeFile> files);

/// The table of formats and stages (formats/README.md, "The table of formats"): a JSON object of the lists `formats`,
/// `tools` and `optional_inputs`, a row on each line.
std::string format_list();

}  // namespace quadrille::stage
