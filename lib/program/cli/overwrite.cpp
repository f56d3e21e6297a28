#include "cli/overwrite.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
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

/// Two names of one file, which need not exist: its folder does.
bool are_same(const std::string& a, const std::string& b) {
  if (const auto id = id_of(a, false)) return id == id_of(b, false);
  std::error_code unknown;
  const auto canonical = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, unknown), unknown);
  };
  return !std::filesystem::exists(a, unknown) && canonical(a) == canonical(b) && !unknown;
}

void refuse_one_for_two(const std::vector<std::string>& written) {
  for (auto one = written.begin(); one != written.end(); ++one)
    for (auto other = written.begin(); other != one; ++other) {
      if (one->empty() || other->empty()) continue;
      if (*one == "-" && *other == "-")
        throw UsageError("two outputs cannot both go to standard output: name a file for one of them");
      if (*one != "-" && *other != "-" && are_same(*one, *other))
        throw UsageError(fmt::format("{}: is written twice: give two names", *one));
    }
}

}  // namespace

void refuse_to_overwrite(const std::vector<std::string>& read, const std::vector<std::string>& written) {
  for (const std::string& output : written) {
    const std::optional<FileId> id = id_of(output, false);
    if (!id) continue;
    const auto same =
        std::find_if(read.begin(), read.end(), [&](const std::string& input) { return id_of(input, true) == id; });
    if (same != read.end())
      throw UsageError(fmt::format("{}: is the input {} and would be overwritten: give another output file", output,
                                   *same == "-" ? "on standard input" : *same));
  }
  refuse_one_for_two(written);
}

}  // namespace quadrille::cli
