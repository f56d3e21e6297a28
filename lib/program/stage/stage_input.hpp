#pragma once
// A struct with the file that it was read from or, in one process, is written to.

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/options.hpp"
#include "base/version.hpp"
#include "model/cad_face.hpp"
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

/// Throws UsageError if the face is curved: the places in the file that `option` names are those of a plane, and nobody
/// knows where the plane of its chart has them.
inline void require_plane_for(const std::string& option, const CadFace& face) {
  if (face.chart)
    throw UsageError(option +
                     ": places in the file are those of a plane, and this face is curved: give sizes by --size "
                     "and --size-near NAME=H");
}

}  // namespace quadrille::stage
