#include "base/child_process.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>

#include "base/error.hpp"

namespace quadrille {
namespace {

[[maybe_unused]] constexpr rlim_t most_memory = 4ULL << 30;

// Message from the child: one letter for the kind of outcome; the rule and a zero byte for a FormatError; then the
// text.
enum Outcome : char { value = 'v', error = 'e', format_error = 'f', other = 'x' };

void write_all(int fd, const char* data, size_t size) {
  while (size > 0) {
    const ssize_t n = write(fd, data, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) _exit(1);
    data += n, size -= static_cast<size_t>(n);
  }
}

std::string read_all(int fd) {
  std::string bytes;
  char buffer[65536];
  for (;;) {
    const ssize_t n = read(fd, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return bytes;
    bytes.append(buffer, static_cast<size_t>(n));
  }
}

std::string outcome_of(const std::function<std::string()>& work) {
  try {
    return std::string(1, value) + work();
  } catch (const FormatError& e) {
    return std::string(1, format_error) + e.rule + '\0' + e.what();
  } catch (const Error& e) {
    return std::string(1, error) + static_cast<char>(e.code()) + e.what();
  } catch (const std::bad_alloc&) {
    _exit(1);
  } catch (const std::exception& e) {
    return std::string(1, other) + e.what();
  } catch (...) {
    return std::string(1, other) + "unknown exception";
  }
}

[[noreturn]] void run_child(const std::function<std::string()>& work, int fd, int cpu_seconds, pid_t parent) {
  // The child ends if its parent is killed, since no process would read its result.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  const rlimit no_core{0, 0}, cpu{static_cast<rlim_t>(cpu_seconds), static_cast<rlim_t>(cpu_seconds) + 1};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_CPU, &cpu);
#ifndef __SANITIZE_ADDRESS__
  // A count read from garbage must not exhaust the memory. (Not under a sanitizer, whose shadow memory would count.)
  const rlimit memory{most_memory, most_memory};
  setrlimit(RLIMIT_DATA, &memory);
#endif
  // The parent's handlers would remove the parent's temporaries, so the child resets them.
  for (const int signal :
       {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL})
    std::signal(signal, SIG_DFL);
  const std::string bytes = outcome_of(work);
  write_all(fd, bytes.data(), bytes.size());
  // _exit instead of exit: buffers and exit handlers belong to the parent.
  _exit(0);
}

[[noreturn]] void rethrow(const std::string& bytes) {
  if (bytes[0] == format_error) {
    const size_t end = bytes.find('\0', 1);
    FormatError e(bytes.substr(end + 1));
    e.rule = bytes.substr(1, end - 1);
    throw e;
  }
  if (bytes[0] == error) {
    const std::string message = bytes.substr(2);
    switch (static_cast<ExitCode>(bytes[1])) {
      case ExitCode::no_result:
        throw ComputeError(message);
      case ExitCode::usage:
        throw UsageError(message);
      case ExitCode::bad_output:
        throw OutputError(message);
      default:
        throw Defect(message);
    }
  }
  throw Defect(bytes.substr(1));
}

}  // namespace

std::string run_in_child(const std::function<std::string()>& work, const std::string& crash_message, int cpu_seconds) {
  int ends[2];
  if (pipe(ends) != 0) throw Defect(std::string("cannot make a pipe: ") + std::strerror(errno));
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw Defect(std::string("cannot start a process: ") + std::strerror(errno));
  if (child == 0) {
    close(ends[0]);
    run_child(work, ends[1], cpu_seconds, parent);
  }
  close(ends[1]);
  const std::string bytes = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  // Sanitizers turn a crash into an exit code, so everything but a clean exit counts as a crash.
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) throw FormatError(crash_message);
  if (bytes[0] == value) return bytes.substr(1);
  rethrow(bytes);
}

}  // namespace quadrille
