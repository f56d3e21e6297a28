#pragma once
// One run at a time on the stage files of a shape in a folder.

#include <string>

namespace quadrille::chain {

/// Holds the files STEM.* of a folder as long as it exists. A second run waits, in other processes and on other
/// machines too where the file system has locks; where it has none, nobody waits.
class FolderLock {
 public:
  /// `stem`: path without the endings. The file FOLDER/.NAME.lock exists while a run holds it.
  explicit FolderLock(const std::string& stem, bool is_quiet);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::string path_;
  int fd_ = -1, slot_ = -1;
};

}  // namespace quadrille::chain
