#pragma once
// Writes and reads a stage file, header included, from the description of its members. Private to io.
//
// FORMAT_io.cpp defines describe(Archive&, Model&) and instantiates the functions of its struct:
//   template QuadMesh read_stage(const InputFile&);
//   template std::string stage_bytes(const QuadMesh&);

#include <functional>
#include <string>

#include "io/archive.hpp"
#include "io/header.hpp"
#include "io/input_file.hpp"
#include "io/stage_files.hpp"

namespace quadrille::io {

using Describe = std::function<void(Archive&)>;

std::string described_bytes(const StageFormat& format, const Provenance& provenance, const Describe& describe);
/// `provenance` is read before `describe` runs.
void read_described(const InputFile& file, const StageFormat& format, Provenance& provenance, const Describe& describe);

template <typename Model>
Model read_stage(const InputFile& file) {
  Model model;
  read_described(file, format_of<Model>(), model.provenance, [&](Archive& archive) { describe(archive, model); });
  return model;
}

template <typename Model>
std::string stage_bytes(const Model& model) {
  Model copy = model;  // a description needs a mutable object, since it may also read
  return described_bytes(format_of<Model>(), model.provenance, [&](Archive& archive) { describe(archive, copy); });
}

}  // namespace quadrille::io
