#include "chain/chain_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/error.hpp"
#include "chain/chain_inputs.hpp"
#include "check/check.hpp"
#include "cli/messages.hpp"
#include "cli/run_files.hpp"
#include "cli/stage_words.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

namespace {

/// Records form and number of the nodes in use, for the report.
void note_nodes(ChainState& chain, const CriticalPoints& nodes) {
  chain.form = nodes.form;
  chain.num_nodes = nodes.critical_points.size();
}

/// Nothing if there is no such file, or another one.
std::optional<CriticalPoints> readable_nodes(const std::string& path) {
  try {
    return io::read_stage<CriticalPoints>(io::read_input(path));
  } catch (const FormatError&) {
    return std::nullopt;  // the stage that needs it says what is wrong
  }
}

/// As if critpoints had written them; --nodes may be that file itself.
void copy_given_nodes(ChainState& chain, NodeFiles& files) {
  const std::string& given = chain.options.nodes_file;
  chain.has_fixed_nodes = true;
  chain.last = files.nodes.path();
  if (chain.options.is_dry_run) {
    if (!cli::are_same_file(given, files.nodes.path()))
      cli::print_to_stdout(
          fmt::format("{}\n", shell_command({"cp", given == "-" ? "/dev/stdin" : given, files.nodes.path()})));
    return;
  }
  io::InputFile file = read_input(chain, given);
  if (given == "-") require_nodes(file);
  std::error_code ignored;
  if (given != "-" && !std::filesystem::is_regular_file(given, ignored))  // a pipe: read once
    file.name = files.nodes.path();
  files.nodes.read(file);
  note_nodes(chain, files.nodes.model());
  if (!cli::are_same_file(given, files.nodes.path()))
    io::write_output(files.nodes.path(), file.bytes, false, io::Lasting::for_the_run);
}

bool run_critpoints(ChainState& chain, StageFile<CriticalPoints>& nodes, const std::vector<std::string>& words) {
  StageTask task{ChainStage::critpoints, false, {chain.files.field.path()}};
  task.words.insert(task.words.end(), words.begin(), words.end());
  auto& found = chain.values.critpoints.choose.found;  // in the field, which stays
  if (!found) found = std::make_shared<choice::Found>();
  const auto points = [&](Run& run) {
    stage::CritpointsOptions options = chain.values.critpoints;
    cli::set_options([&](Options& o) { declare(o, options); }, words);
    return stage::critpoints(chain.files.field.input(), options, run);
  };
  if (!make_file(chain, std::move(task), nodes, points, chain.files.field)) return false;
  if (chain.is_due(ChainStage::critpoints) && !chain.options.is_dry_run) note_nodes(chain, nodes.model());
  return true;
}

bool has_nodes_by_hand(const CriticalPoints& points) {
  return std::any_of(points.critical_points.begin(), points.critical_points.end(),
                     [](const CriticalPoint& point) { return point.source == NodeSource::hand; });
}

/// Whether one file was made as the other, by the same tools with the same options and inputs.
bool have_same_provenance(const CriticalPoints& points, const CriticalPoints& other) {
  CriticalPoints first, second;
  first.provenance = points.provenance;
  second.provenance = other.provenance;
  return io::stage_bytes(first) == io::stage_bytes(second);
}

/// Runs critpoints; a file with the same provenance but other content was edited, and is kept. With another provenance,
/// that is with other options, it is replaced, but not if it has nodes that were set by hand.
bool find_nodes_again(ChainState& chain, NodeFiles& files, const std::vector<std::string>& words) {
  if (chain.options.is_dry_run) {
    cli::print_to_stdout(fmt::format("# {} is kept if it was edited after critpoints wrote it\n", files.nodes.path()));
    return run_critpoints(chain, files.nodes, words);
  }
  StageFile<CriticalPoints> found(chain.runner.scratch() + "/found.crit.json");
  if (!run_critpoints(chain, found, words)) return false;
  chain.last = files.nodes.path();
  const io::InputFile present = io::read_input(files.nodes.path());
  files.nodes.read(present);
  const std::string bytes = io::stage_bytes(found.model());
  if (bytes == present.bytes) return true;
  if (have_same_provenance(found.model(), files.nodes.model())) {
    chain.has_fixed_nodes = true;
    note_nodes(chain, files.nodes.model());
    inform(chain, files.nodes.path() + " was edited after critpoints wrote it: its nodes are used");
    return true;
  }
  if (has_nodes_by_hand(files.nodes.model()))
    throw ChainFailure{ExitCode::usage, "quadmesh",
                       files.nodes.path() +
                           " was edited, but made with other options of critpoints: use it with --from separatrix, or "
                           "remove it",
                       false};
  files.nodes.set(found.release(), true);
  return true;
}

}  // namespace

bool make_nodes(ChainState& chain, NodeFiles& files, const std::vector<std::string>& words) {
  if (!chain.options.nodes_file.empty()) {
    copy_given_nodes(chain, files);
    return true;
  }
  if (is_before(ChainStage::critpoints, chain.options.first)) {
    chain.has_fixed_nodes = true;
    if (const auto present = readable_nodes(files.nodes.path())) note_nodes(chain, *present);
    return true;
  }
  std::error_code ignored;
  const bool is_there = std::filesystem::file_size(files.nodes.path(), ignored) > 0 && !ignored;
  if (chain.options.first == ChainStage::critpoints && is_there && chain.prefix.empty())
    return find_nodes_again(chain, files, words);
  return run_critpoints(chain, files.nodes, words);
}

bool have_phase_form(ChainState& chain, NodeFiles& files) {
  if (files.nodes.is_in_memory()) return files.nodes.model().form == NodeForm::phase;
  const std::string& given = chain.options.nodes_file;
  const auto nodes = readable_nodes(given.empty() ? files.nodes.path() : given);
  return nodes && nodes->form == NodeForm::phase;
}

bool needs_own_field(ChainState& chain, NodeFiles& files) {
  if (have_phase_form(chain, files)) return true;
  if (!chain.has_fixed_nodes || chain.options.is_dry_run || !chain.is_due(ChainStage::separatrix)) return false;
  try {
    return !stage::reason_to_solve_for(files.nodes.input(), chain.files.field.input()).empty();
  } catch (const FormatError&) {
    return false;  // separatrix says what is wrong
  }
}

void require_nodes(const io::InputFile& file) {
  const std::string format = io::stage_format(file);
  if (format != "critical-points")
    throw FormatError(
        fmt::format("{}: expected a critical-points file (x.crit.json), found format {}", file.name, format));
  for (const check::Violation& violation :
       check::check_stage(io::read_stage<CriticalPoints>(file), check::CheckDepth::full))
    if (violation.rule != "CRT-R07" && violation.rule != "CRT-R16")
      throw FormatError(fmt::format("{}: {}: {}", file.name, violation.rule, violation.text));
}

}  // namespace quadrille::chain
