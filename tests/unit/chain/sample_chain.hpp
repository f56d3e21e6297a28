#pragma once
// What the tests of this folder share: a run of the chain in a folder of its own, before its first stage.

#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "chain/chain_state.hpp"
#include "temporary_folder.hpp"

namespace quadrille::chain {

struct SampleChain {
  explicit SampleChain(bool in_children = false, Limits limits = {})
      : runner(options, Budget(limits), in_children, folder.path()),
        chain(options, stage_options(options), runner, folder.file("shape")) {}

  /// As from the command line.
  void read(const std::vector<std::string>& words) {
    read_command_line(words, options);
    chain.values = stage_options(options);
  }
  /// The path of a new file with this content.
  std::string put(const std::string& name, const std::string& content) const {
    std::ofstream(folder.file(name), std::ios::binary) << content;
    return folder.file(name);
  }
  std::string content(const std::string& name) const {
    std::ifstream in(folder.file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// The stages that have run, each with a blank behind it.
  std::string stages() const {
    std::string names;
    for (const io::StageReport& report : runner.reports()) names += report.stage + ' ';
    return names;
  }

  TemporaryFolder folder;
  ChainOptions options;
  StageRunner runner;
  ChainState chain;
};

/// What `act` writes to standard error.
template <typename Act>
std::string errors_of(const Act& act) {
  testing::internal::CaptureStderr();
  act();
  return testing::internal::GetCapturedStderr();
}

/// What `act` writes to standard output.
template <typename Act>
std::string output_of(const Act& act) {
  testing::internal::CaptureStdout();
  act();
  return testing::internal::GetCapturedStdout();
}

/// The failure with which `act` ends the run; with code 0 if the run succeeds.
template <typename Act>
ChainFailure failure_of(const Act& act) {
  try {
    act();
  } catch (const ChainFailure& failure) {
    return failure;
  }
  return {};
}

/// A task that does `compute` and has neither inputs nor a result.
inline StageTask task_of(ChainStage stage, std::function<void(Run&)> compute) {
  StageTask task;
  task.stage = stage;
  task.name = enum_name(stage);
  task.output = "out";
  task.words = {"in"};
  task.compute = std::move(compute);
  task.write_inputs = [] {};
  return task;
}

}  // namespace quadrille::chain
