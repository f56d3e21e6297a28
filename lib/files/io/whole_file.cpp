#include "io/whole_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/child_process.hpp"
#include "base/cleanup.hpp"
#include "base/error.hpp"
#include "io/digest.hpp"

namespace quadrille::io {

namespace {

struct Descriptor {
  int fd = -1;
  bool is_owned = false;
  ~Descriptor() {
    if (is_owned && fd >= 0) close(fd);
  }
};

[[noreturn]] void fail_reading(const std::string& name) {
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
    if (got < 0) fail_reading(name);
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  bytes.resize(size);
  return bytes;
}

[[noreturn]] void fail(const std::string& name) {
  require_resources(errno, name + ": cannot be written");
  throw OutputError(fmt::format("{}: cannot be written: {}", name, std::strerror(errno)));
}

void write_all(int fd, const std::string& bytes, const std::string& name) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t put = write(fd, bytes.data() + done, bytes.size() - done);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) fail(name);
    done += static_cast<std::size_t>(put);
  }
}

/// Whether the output is a pipe, a device or the like, which cannot be renamed.
void write_directly(const std::string& path, const std::string& bytes) {
  const int fd = open(path.c_str(), O_WRONLY | O_TRUNC);
  if (fd < 0) fail(path);
  try {
    write_all(fd, bytes, path);
  } catch (...) {
    close(fd);
    throw;
  }
  if (close(fd) != 0) fail(path);
}

std::uint64_t random_number() {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number) number = static_cast<std::uint64_t>(getpid());
  return number;
}

/// The temporary file of one output: removed unless it was renamed, also if a signal ends the process.
class Temporary {
 public:
  explicit Temporary(const std::string& target) : target_(target) {
    // The name is short, whatever the target's, and nobody else's: an existing file is never opened.
    const std::string folder = target.substr(0, target.rfind('/') + 1);  // npos + 1 is 0
    do {
      release_temporary(slot_);
      path_ = fmt::format("{}.{:016x}.tmp", folder, random_number());
      slot_ = register_temporary(path_);
      fd_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (fd_ < 0 && errno == EEXIST);
    if (fd_ < 0) {
      release_temporary(slot_);
      fail(target_);
    }
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (fd_ >= 0) close(fd_);
    if (!is_renamed_) unlink(path_.c_str());
    release_temporary(slot_);
  }

  void keep_mode_of(const struct stat& existing) { static_cast<void>(fchmod(fd_, existing.st_mode & 07777)); }
  void write(const std::string& bytes) { write_all(fd_, bytes, target_); }
  void store() {
    if (fsync(fd_) != 0 && errno != EINVAL && errno != ENOTSUP) fail(target_);
  }
  void rename() {
    // Some file systems report a full disk only here.
    const int fd = fd_;
    fd_ = -1;
    if (close(fd) != 0 || std::rename(path_.c_str(), target_.c_str()) != 0) fail(target_);
    is_renamed_ = true;
  }

 private:
  std::string target_, path_;
  int slot_ = -1, fd_ = -1;
  bool is_renamed_ = false;
};

/// A symbolic link is kept: its target is replaced.
std::string resolved(const std::string& path) {
  char real[PATH_MAX];
  return realpath(path.c_str(), real) ? std::string(real) : path;
}

bool is_descriptor_name(const std::string& path) {
  return path == "/dev/stderr" || path.starts_with("/dev/fd/") || path.starts_with("/proc/");
}

}  // namespace

InputFile read_input(const std::string& path) {
  InputFile file;
  file.name = path == "-" ? "standard input" : path;
  const Descriptor in = path == "-" ? Descriptor{STDIN_FILENO} : Descriptor{open(path.c_str(), O_RDONLY), true};
  struct stat status {};
  if (in.fd < 0 || fstat(in.fd, &status) != 0) fail_reading(file.name);
  if (S_ISDIR(status.st_mode)) throw FormatError(fmt::format("{}: is a directory, not a file", file.name));
  if (isatty(in.fd)) throw FormatError(fmt::format("{}: is a terminal; name an input file or redirect one", file.name));
  file.bytes = read_all(in.fd, S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 65535, file.name);
  if (file.bytes.empty()) throw FormatError(fmt::format("{}: is empty", file.name));
  file.sha256 = sha256_hex(file.bytes);
  return file;
}

void write_output(const std::string& path, const std::string& bytes, bool is_binary, Lasting lasting) {
  if (path == "-" || path == "/dev/stdout") {
    if (is_binary && isatty(STDOUT_FILENO))
      throw OutputError("standard output is a terminal: binary data is not written to it; give -o FILE or a pipe");
    write_all(STDOUT_FILENO, bytes, "standard output");
    return;
  }
  struct stat existing {};
  const bool exists = stat(path.c_str(), &existing) == 0;
  if (exists && S_ISDIR(existing.st_mode)) {
    errno = EISDIR;
    fail(path);
  }
  if (exists && (!S_ISREG(existing.st_mode) || is_descriptor_name(path))) return write_directly(path, bytes);
  if (exists && access(path.c_str(), W_OK) != 0) fail(path);
  Temporary temporary(exists ? resolved(path) : path);
  if (exists) temporary.keep_mode_of(existing);
  temporary.write(bytes);
  if (lasting == Lasting::on_disk) temporary.store();
  temporary.rename();
}

}  // namespace quadrille::io
