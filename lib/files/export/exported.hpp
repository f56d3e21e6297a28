#pragma once
// The result of the writer of a solver format.

#include <string>
#include <vector>

#include "model/length_scale.hpp"

namespace quadrille::exports {

/// A file that a format needs beside the main one, such as a table of names.
struct SideFile {
  std::string ending;  ///< replaces the ending of the main file: ".curves.vtu"
  std::string bytes;
  bool is_binary = false;
  bool is_appended = false;  ///< `ending` follows the whole name of the main file: x.re2.names.json
};

struct Exported {
  std::string bytes;
  bool is_binary = false;
  std::vector<SideFile> side_files;
  /// Properties of this mesh that the format cannot represent: one sentence each, with the magnitude of the loss.
  /// A file beside the main one is called * and its ending there.
  std::vector<std::string> losses;
  LengthScale length{};  ///< of the coordinates, set by export_mesh

  /// A sentence; nothing if it is empty.
  void add_loss(const std::string& loss) {
    if (!loss.empty()) losses.push_back(loss);
  }
};

}  // namespace quadrille::exports
