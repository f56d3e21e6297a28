#pragma once
// Component `files`: reads, checks and writes the stage files (formats/README.md).
//
// Positions in the structs are relative to face.origin, lengths in the unit of the CAD file, indices count from 0.
// Errors are thrown (base/error.hpp): FormatError for a file that is not what it should be, OutputError for one that
// cannot be written. "-" is standard input or output.
//
// What the functions of the components make has the provenance of the tools' files, so that the tools take these files
// like their own.

#include <string>
#include <vector>

#include "model/stage_formats.hpp"

namespace quadrille::api {

/// Reads one file of any format and checks the rules without which it could not be used, as the tools do.
StageModel read_stage(const std::string& path);

/// The same if the file is of `format`, "quad-mesh"; throws FormatError for any other.
StageModel read_stage(const std::string& path, const std::string& format);

/// The same as the struct that is in the file: read<QuadMesh>(path).
template <typename Model>
Model read(const std::string& path) {
  return std::get<Model>(read_stage(path, format_of<Model>().name));
}

/// Writes one file, completely or not at all.
void write(const std::string& path, const StageModel& model);

/// A numbered rule of a format that does not hold: its number ("TRI-R01"), what is wrong and where.
struct BrokenRule {
  std::string number, text;
};

/// All rules of the format, as stagecheck checks them; empty if they hold.
std::vector<BrokenRule> broken_rules(const StageModel& model);

}  // namespace quadrille::api
