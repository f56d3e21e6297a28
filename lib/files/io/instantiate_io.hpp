#pragma once
// FORMAT_io.cpp defines describe(Archive&, Model&) and instantiates the functions of its struct:
//   template QuadMesh read_stage(const InputFile&);
//   template std::string stage_bytes(const QuadMesh&);
// Private to those sources.

#include "io/stage_files.hpp"
#include "io/stage_io.hpp"

namespace quadrille::io {

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
