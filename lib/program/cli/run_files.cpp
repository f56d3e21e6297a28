#include "cli/run_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <optional>

#include "base/error.hpp"

namespace quadrille::cli {

namespace {

struct FileId {
  dev_t device;
  ino_t inode;
  bool operator==(const FileId&) const = default;
};

std::optional<FileId> id_of(const std::string& path, bool is_read) {
  struct stat status {};
  if (path.empty() || (path == "-" && !is_read)) return std::nullopt;
  const int failed = path == "-" ? fstat(STDIN_FILENO, &status) : stat(path.c_str(), &status);
  if (failed != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileId{status.st_dev, status.st_ino};
}

}  // namespace

void RunFiles::read(const std::string& path) {
  if (!path.empty()) read_.push_back(path);
}

void RunFiles::write(const std::string& path, const std::string& what) {
  if (!path.empty()) written_.push_back({path, what});
}

void RunFiles::require_distinct() const {
  for (auto one = written_.begin(); one != written_.end(); ++one) {
    const std::optional<FileId> id = id_of(one->path, false);
    for (const std::string& input : read_)
      if (id && id_of(input, true) == id)
        throw UsageError(fmt::format("{}: is the input {}, which {} would overwrite: give another file", one->path,
                                     input == "-" ? "on standard input" : input, one->what));
    for (auto other = written_.begin(); other != one; ++other) {
      if (one->path == "-" && other->path == "-")
        throw UsageError(fmt::format("{} and {} cannot both go to standard output: name a file for one of them",
                                     other->what, one->what));
      if (one->path != "-" && other->path != "-" && are_same_file(one->path, other->path))
        throw UsageError(fmt::format("{}: would be written twice, by {} and by {}: give two names", one->path,
                                     other->what, one->what));
    }
  }
}

bool are_same_file(const std::string& a, const std::string& b) {
  if (const auto id = id_of(a, false)) return id == id_of(b, false);
  std::error_code unknown;
  const auto canonical = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, unknown), unknown);
  };
  return !std::filesystem::exists(a, unknown) && canonical(a) == canonical(b) && !unknown;
}

}  // namespace quadrille::cli
