#include "io/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"
#include "base/resources.hpp"
#include "io/sha256.hpp"

namespace quadrille::io {

namespace {

struct Descriptor {
  int fd = -1;
  bool is_owned = false;
  ~Descriptor() {
    if (is_owned && fd >= 0) close(fd);
  }
};

[[noreturn]] void fail(const std::string& name) {
  require_resources(errno, name + ": cannot be read");
  throw FormatError(fmt::format("{}: cannot be read: {}", name, std::strerror(errno)));
}

std::string read_all(int fd, std::size_t expected, const std::string& name) {
  std::string bytes(expected + 1, '\0');  // one more than expected: the end is detected without resizing
  std::size_t size = 0;
  for (;;) {
    if (size == bytes.size()) bytes.resize(std::max<std::size_t>(2 * size, 65536));
    const ssize_t got = read(fd, bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(name);
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

InputFile read_input(const std::string& path) {
  InputFile file;
  file.name = path == "-" ? "standard input" : path;
  const Descriptor in = path == "-" ? Descriptor{STDIN_FILENO} : Descriptor{open(path.c_str(), O_RDONLY), true};
  struct stat status {};
  if (in.fd < 0 || fstat(in.fd, &status) != 0) fail(file.name);
  if (S_ISDIR(status.st_mode)) throw FormatError(fmt::format("{}: is a directory, not a file", file.name));
  if (isatty(in.fd)) throw FormatError(fmt::format("{}: is a terminal; name an input file or redirect one", file.name));
  file.bytes = read_all(in.fd, S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 65535, file.name);
  if (file.bytes.empty()) throw FormatError(fmt::format("{}: is empty", file.name));
  file.sha256 = sha256_hex(file.bytes);
  return file;
}

}  // namespace quadrille::io
