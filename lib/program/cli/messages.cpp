#include "cli/messages.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <utility>

#include "base/error.hpp"
#include "base/name_text.hpp"

namespace quadrille::cli {

namespace {

/// Writes all that can be written; false if the reader of a pipe has gone.
bool write_text(std::string_view text, int descriptor) {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN) {
      pollfd ready{descriptor, POLLOUT, 0};
      poll(&ready, 1, -1);
    } else if (errno != EINTR) {
      return errno != EPIPE;
    }
  }
  return true;
}

void write_without_signal(std::string_view text, int descriptor) noexcept {
  sigset_t of_pipes, before;
  sigemptyset(&of_pipes);
  sigaddset(&of_pipes, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &of_pipes, &before);
  const timespec at_once{};
  if (!write_text(text, descriptor)) sigtimedwait(&of_pipes, nullptr, &at_once);  // takes the signal of this write
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace

void print_message(std::string_view text, int descriptor) { write_without_signal(printable_text(text), descriptor); }

void write_to_terminal(std::string_view text) noexcept { write_without_signal(text, STDERR_FILENO); }

void print_to_stdout(std::string_view words) {
  const std::string text = printable_text(words);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw OutputError("standard output: cannot be written");
}

void occupy_standard_streams() noexcept {
  // Output gets a descriptor that cannot be written to, so that a result is not lost without a word.
  for (const auto& [descriptor, flags] :
       {std::pair{STDIN_FILENO, O_RDONLY}, {STDOUT_FILENO, O_RDONLY}, {STDERR_FILENO, O_WRONLY}})
    if (fcntl(descriptor, F_GETFD) < 0) open("/dev/null", flags);  // the lowest that is free
}

}  // namespace quadrille::cli
