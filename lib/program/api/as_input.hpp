#pragma once
// Structs of a program as the input of a stage function. Private to api.

#include <string>
#include <vector>

#include "base/run.hpp"
#include "io/stage_files.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::api {

/// With the digest that the file of the struct would have, so that results have the provenance of the tools' files.
template <typename Model>
stage::Input<Model> as_input(const Model& model, const std::string& name) {
  return {model, io::identity_of(name, io::stage_bytes(model))};
}

/// Adds the warnings of a run to `warnings`, unless it is null.
inline void add_warnings(Run& run, std::vector<std::string>* warnings) {
  if (!warnings) return;
  for (const Report::Warning& warning : run.report().warnings()) warnings->push_back(warning.message);
}

}  // namespace quadrille::api
