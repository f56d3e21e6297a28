#pragma once
// The result of the writer of a solver format.

#include <string>
#include <vector>

namespace quadrille::exports {

/// A file that a format needs beside the main one, such as a table of names.
struct SideFile {
  std::string ending;  ///< replaces the ending of the main file: ".names.json"
  std::string bytes;
  bool is_binary = false;
};

struct Exported {
  std::string bytes;
  bool is_binary = false;
  std::vector<SideFile> side_files;
  /// Properties of this mesh that the format cannot represent: one sentence each, with the magnitude of the loss.
  std::vector<std::string> losses;
};

}  // namespace quadrille::exports
