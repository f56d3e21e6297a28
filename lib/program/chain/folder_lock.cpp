#include "chain/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/cleanup.hpp"
#include "cli/messages.hpp"

namespace quadrille::chain {

namespace {

/// Waits; false where there are no locks.
bool lock_file(int fd) {
  while (flock(fd, LOCK_EX) != 0)
    if (errno != EINTR) return false;
  return true;
}

/// Whether the path still names the file: the run before removes it.
bool is_named(int fd, const std::string& path) {
  struct stat open_file {
  }, named{};
  return fstat(fd, &open_file) == 0 && stat(path.c_str(), &named) == 0 && open_file.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::string& stem, bool is_quiet) {
  const std::size_t name = stem.rfind('/') + 1;  // npos + 1 is 0
  path_ = stem.substr(0, name) + '.' + stem.substr(name) + ".lock";
  bool is_told = is_quiet;
  for (;;) {
    fd_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (fd_ < 0) return;
    if (flock(fd_, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK && !is_told)
        cli::print_message(fmt::format("quadmesh: waits for another run that works on {}.*\n", stem));
      is_told = true;
      if (!lock_file(fd_)) break;
    }
    if (is_named(fd_, path_)) break;
    close(fd_);
  }
  slot_ = register_temporary(path_);
}

FolderLock::~FolderLock() {
  if (fd_ < 0) return;
  unlink(path_.c_str());
  release_temporary(slot_);
  close(fd_);
}

}  // namespace quadrille::chain
