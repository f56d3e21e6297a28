#pragma once
// A command never replaces a file that it reads, nor one that it writes itself.

#include <string>
#include <vector>

namespace quadrille::cli {

/// The files of a run. All are named before the run reads or computes anything: those of the command line, stage files,
/// and files that a format has beside the main one.
class RunFiles {
 public:
  /// Empty paths are ignored; "-" is standard input.
  void read(const std::string& path);
  /// "-" is standard output. `what` is for messages: "--report", "the stage padapt".
  void write(const std::string& path, const std::string& what);

  /// Throws UsageError if a file that is written is the same regular file as one that is read, also by another name of
  /// it: another path, a link, or a redirection. Files that do not exist are different from all that are read. Throws
  /// UsageError too if two files that are written are one, existing or not, or both are standard output.
  void require_distinct() const;

 private:
  struct Written {
    std::string path, what;
  };
  std::vector<std::string> read_;
  std::vector<Written> written_;
};

/// Two names of one file, which need not exist: its folder does.
bool are_same_file(const std::string& a, const std::string& b);

}  // namespace quadrille::cli
