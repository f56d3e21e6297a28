#pragma once
// A struct with the file that it was read from or, in one process, is written to.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/options.hpp"
#include "base/version.hpp"
#include "model/provenance.hpp"

namespace quadrille::stage {

/// The model must outlive this.
template <typename Model>
struct Input {
  Input(const Model& of_file, FileIdentity identity) : model(of_file), file(std::move(identity)) {}

  const Model& model;
  FileIdentity file;
};

/// What a file contains that an option names, with its identity; nothing without a file.
template <typename Content>
struct Prescribed {
  Content content = {};
  std::optional<FileIdentity> file = {};

  /// For a stage; this must outlive it.
  std::optional<Input<Content>> input() const {
    if (!file) return std::nullopt;
    return std::optional<Input<Content>>(std::in_place, content, *file);
  }
};

/// Opens the file `path`, if there is one, and reads it.
template <typename Open, typename Read>
auto prescribed(const std::string& path, const Open& open, const Read& read) {
  using Content = decltype(read(open(path)));
  if (path.empty()) return Prescribed<Content>{};
  const auto file = open(path);
  return Prescribed<Content>{read(file), file};
}

/// The chain `before` with the step of the tool `tool` and its recorded options appended.
template <typename Options>
Provenance with_step(Provenance before, const std::string& tool, const Options& options,
                     std::vector<InputDigest> inputs) {
  before.push_back({tool, version, std::move(inputs), recorded_options(options)});
  return before;
}

}  // namespace quadrille::stage
