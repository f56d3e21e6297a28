#pragma once
// A struct with the file that it was read from or, in one process, is written to.

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

/// The chain `before` with the step of the tool `tool` and its recorded options appended.
template <typename Options>
Provenance with_step(Provenance before, const std::string& tool, const Options& options,
                     std::vector<InputDigest> inputs) {
  before.push_back({tool, version, std::move(inputs), recorded_options(options)});
  return before;
}

}  // namespace quadrille::stage
