#pragma once
// Reading and writing stage files: "-" is stdin or stdout, HDF5 as a file image. One .cpp per format behind this.
// Readers throw FormatError (not that format, other major version, wrong shape or type, truncated), writers
// OutputError.

#include <string>
#include <utility>
#include <variant>

#include "io/whole_file.hpp"
#include "model/stage_formats.hpp"

namespace quadrille::io {

/// The name in stage_formats that the file states; throws FormatError for anything else.
std::string stage_format(const InputFile& file);

/// Whether it is a chart file, which cad2tri reads in place of a CAD file. Throws FormatError for a damaged one.
bool is_chart(const InputFile& file);

/// Reads the file of the struct that `stage` holds into it.
void read_into(const InputFile& file, StageModel& stage);

template <typename Model>
Model read_stage(const InputFile& file) {
  StageModel stage(std::in_place_type<Model>);
  read_into(file, stage);
  return std::get<Model>(std::move(stage));
}

/// Reads a file of whatever format it states.
StageModel read_any_stage(const InputFile& file);

/// The CAD face at the root of x.tri.h5, x.sep.json, x.blocks.h5 or x.quad.h5, whatever else is in the file.
CadFace read_face(const InputFile& file);

/// The bytes of the file: HDF5 or JSON.
std::string stage_bytes(StageModel stage);

/// Writes the bytes of a stage file to `path`, completely or not at all.
void write_stage_bytes(const std::string& path, const std::string& bytes, Lasting lasting = Lasting::on_disk);
void write_stage(const std::string& path, const StageModel& stage);

/// The name and the digest that a file of these bytes has.
FileIdentity identity_of(const std::string& name, const std::string& bytes);

}  // namespace quadrille::io
