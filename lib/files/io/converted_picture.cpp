#include "io/converted_picture.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace quadrille::io {

namespace {

constexpr const char* program = "rsvg-convert";

/// A file in memory: no pipe can be filled while the other end waits.
class MemoryFile {
 public:
  MemoryFile() : fd_(memfd_create("picture", MFD_CLOEXEC)) {}
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    if (fd_ >= 0) close(fd_);
  }

  int fd() const { return fd_; }

  bool fill(const std::string& bytes) const {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t put = write(fd_, bytes.data() + done, bytes.size() - done);
      if (put < 0 && errno == EINTR) continue;
      if (put < 0) return false;
      done += static_cast<std::size_t>(put);
    }
    return lseek(fd_, 0, SEEK_SET) == 0;
  }

  std::string content() const {
    std::string bytes;
    std::array<char, 65536> buffer{};
    lseek(fd_, 0, SEEK_SET);
    for (;;) {
      const ssize_t count = read(fd_, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return bytes;
      bytes.append(buffer.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  int fd_;
};

/// The environment with a fixed date for PDF (reproducible-builds.org, SOURCE_DATE_EPOCH).
std::vector<char*> environment_of_fixed_date(std::string& date) {
  std::vector<char*> result;
  for (char** entry = environ; entry && *entry; ++entry)
    if (!std::string_view(*entry).starts_with("SOURCE_DATE_EPOCH=")) result.push_back(*entry);
  result.push_back(date.data());
  result.push_back(nullptr);
  return result;
}

/// Starts the program with three files as its standard streams; 0, or the error number if it cannot be started.
int start(std::vector<std::string> words, const std::array<int, 3>& streams, pid_t& child) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::string date = "SOURCE_DATE_EPOCH=0";
  const std::vector<char*> environment = environment_of_fixed_date(date);
  posix_spawn_file_actions_t actions;
  if (const int error = posix_spawn_file_actions_init(&actions); error != 0) return error;
  int error = 0;
  for (int k = 0; k < 3 && error == 0; ++k) error = posix_spawn_file_actions_adddup2(&actions, streams[k], k);
  if (error == 0) error = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

bool succeeded(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string picture_ending(const std::string& path) {
  const std::string name = path.substr(path.rfind('/') + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || dot == 0) return "";
  std::string ending = name.substr(dot + 1);
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

PictureFormat picture_format(const std::string& path) {
  const std::string ending = picture_ending(path);
  if (ending == "png") return PictureFormat::png;
  if (ending == "pdf") return PictureFormat::pdf;
  if (!ending.empty() && ending != "svg")
    throw UsageError(fmt::format(
        "{}: pictures are written as SVG, PNG or PDF: end the name in .svg, .png or .pdf (or, for a page, in .html)",
        path));
  return PictureFormat::svg;
}

std::string converted_picture(const std::string& svg, PictureFormat format, const std::string& path) {
  if (format == PictureFormat::svg) return svg;
  const MemoryFile input, output, messages;
  if (output.fd() < 0 || messages.fd() < 0 || !input.fill(svg))
    throw OutputError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  pid_t child = 0;
  const std::string name = format == PictureFormat::png ? "png" : "pdf";
  const int error = start({program, "--unlimited", "--format", name}, {input.fd(), output.fd(), messages.fd()}, child);
  if (error == ENOENT)
    throw OutputError(
        fmt::format("{}: cannot be written: the program {} is not installed (package librsvg2-bin of "
                    "Debian): install it, or end the name in .svg",
                    path, program));
  if (error != 0) throw OutputError(fmt::format("{}: cannot be written: {}: {}", path, program, std::strerror(error)));
  const bool is_done = succeeded(child);
  std::string bytes = output.content();
  if (is_done && !bytes.empty()) return bytes;
  const std::string reason = messages.content();
  throw OutputError(
      fmt::format("{}: cannot be written: {} failed: {}", path, program, reason.substr(0, reason.find('\n'))));
}

}  // namespace quadrille::io
