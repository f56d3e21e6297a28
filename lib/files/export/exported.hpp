#pragma once
// The result of the writer of a solver format.

#include <string>
#include <vector>

#include "model/length_scale.hpp"

namespace quadrille::exports {

/// The name of a file beside the main one: what replaces its ending (".curves.vtu") or, if `is_appended`, follows its
/// whole name (x.re2.names.json).
struct SideName {
  std::string ending;
  bool is_appended = false;
};

/// A file that a format needs beside the main one, such as a table of names.
struct SideFile {
  SideName name;
  std::string bytes;
  bool is_binary = false;
};

struct Exported {
  std::string bytes;
  bool is_binary = false;
  std::vector<SideFile> side_files;
  /// Properties of this mesh that the format cannot represent: one sentence each, with the magnitude of the loss.
  /// A file beside the main one is called * and its ending there.
  std::vector<std::string> losses;
  LengthScale length{};  ///< of the coordinates, set by export_mesh
};

}  // namespace quadrille::exports
