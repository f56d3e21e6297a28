#include "cli/overwrite.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
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
}

}  // namespace quadrille::cli
