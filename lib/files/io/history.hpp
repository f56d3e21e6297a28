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

/// A stage file whose history is asked for.
struct MadeFile {
  std::string path, sha256;
  Provenance chain;
};

/// The files in an order in which each one comes after those from which it was made; else as given.
std::vector<MadeFile> oldest_first(std::vector<MadeFile> files);

/// Files have no names in the provenance: they get those of quadmesh --workdir, STEM.tri.h5 to STEM.quad.h5.
class History {
 public:
  /// How the file with this SHA-256 was made: a command for each step, oldest first, without the steps of earlier
  /// calls, whose files are used. A comment "# NAME: FORMAT, SHA-256 ..." precedes the first command that reads a file
  /// of unknown origin. No two files get one name: of two with the same ending the second is STEM.2.tri.h5.
  std::vector<std::string> lines_of(const Provenance& chain, const std::string& sha256, const std::string& stem);

  /// Of a file whose lines were asked for, or that one of them reads.
  const std::string& name_of(const std::string& sha256) const { return names_.at(sha256); }

 private:
  std::string new_name(const std::string& stem, const std::string& ending);

  std::map<std::string, std::string> outputs_;  ///< names of files that commands write, by tool, options and inputs
  std::map<std::string, std::string> names_;    ///< of known files, by SHA-256
  std::set<std::string> used_;                  ///< names
};

}  // namespace quadrille::io
