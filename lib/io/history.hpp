#pragma once
// How a stage file was made, as commands for a shell, from its provenance (formats/README.md, "Provenance").

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/provenance.hpp"

namespace quadrille::io {

/// The name of a file up to its first dot, without folders: "half_disc" of "stages/half_disc.sep.json"; "x" for
/// standard input.
std::string history_stem(const std::string& path);

/// Files have no names in the provenance: they get those of quadmesh --workdir, STEM.tri.h5 to STEM.quad.h5.
class History {
 public:
  /// How the file with this SHA-256 was made: a command for each step, oldest first, without the steps of earlier
  /// calls. A comment "# NAME: FORMAT, SHA-256 ..." precedes the first command that reads a file of unknown origin.
  std::vector<std::string> lines_of(const Provenance& chain, const std::string& sha256, const std::string& stem);

 private:
  std::set<std::string> commands_;            ///< those of earlier calls
  std::map<std::string, std::string> names_;  ///< of known files, by SHA-256
};

}  // namespace quadrille::io
