#include "base/child_process.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>

#include "base/error.hpp"

namespace quadrille {

void require_resources(int error, const std::string& what) {
  const char* resource = nullptr;
  if (error == EAGAIN) resource = "no more processes: raise their limit (ulimit -u)";
  if (error == EMFILE || error == ENFILE) resource = "no more open files: raise their limit (ulimit -n)";
  if (error == ENOMEM) resource = "no more memory: raise its limit (ulimit -v)";
  if (resource != nullptr) throw ComputeError(what + ": " + resource);
}

MemoryUse memory_use() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  file >> size >> resident >> shared >> text >> library >> data;
  const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return {data * page, shared * page};
}

std::uint64_t memory_limit() {
  std::uint64_t least = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA})
    if (rlimit limit{}; getrlimit(resource, &limit) == 0) least = std::min<std::uint64_t>(least, limit.rlim_cur);
  return least;
}

void limit_data([[maybe_unused]] std::uint64_t bytes) {
#ifndef QUADRILLE_SANITIZE  // whose own data would count
  if (memory_use().data > bytes / 2) malloc_trim(0);
  rlimit limit{};
  getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

void limit_stacks(std::size_t bytes) {
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return;
  pthread_attr_setstacksize(&attributes, bytes);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

namespace {

// The first byte from a program that runs. One that ends before has libraries that the dynamic loader does not find, or
// no memory for them; the loader's message is on stderr.
constexpr char has_started = 's';

// Message from the child: one letter for the kind of outcome; the rule and a zero byte for a FormatError; then the
// text.
enum Outcome : char { value = 'v', error = 'e', format_error = 'f', other = 'x', not_started = 'n', no_memory = 'm' };

[[noreturn]] void fail(const char* what) {
  const int error = errno;
  require_resources(error, what);
  throw Defect(std::string(what) + ": " + std::strerror(error));
}

bool has_limited_memory() {
  const auto is_limited = [](auto resource) {
    rlimit memory{};
    return getrlimit(resource, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY;
  };
  return is_limited(RLIMIT_AS) || is_limited(RLIMIT_DATA);
}

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
    return std::string(1, no_memory);
  } catch (const std::exception& e) {
    return std::string(1, other) + e.what();
  } catch (...) {
    return std::string(1, other) + "unknown exception";
  }
}

void limit_child(const ChildLimits& limits) {
  const auto seconds = static_cast<rlim_t>(limits.cpu_seconds);
  const rlimit no_core{0, 0}, cpu{seconds, seconds + 1};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_CPU, &cpu);
  malloc_trim(0);                                // what cli/process_setup reserves would not be limited
  limit_data(memory_use().data + limits.bytes);  // a count read from garbage must not exhaust the memory
}

// The parent's handlers would remove the parent's temporaries. What is ignored stays ignored.
void remove_signal_handlers() {
  for (int signal = 1; signal < NSIG; ++signal) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN && action.sa_handler != SIG_DFL)
      std::signal(signal, SIG_DFL);
  }
}

// _exit instead of exit: buffers and exit handlers belong to the parent, and a program that has answered has nothing
// left to do.
[[noreturn]] void answer(const std::string& bytes, int fd) {
  write_all(fd, bytes.data(), bytes.size());
  _exit(0);
}

// Becomes `program`, with `input` as standard input and `fd` as standard output.
[[noreturn]] void become(std::string program, int input, int fd) {
  // Copies above 2, because the descriptors are 0 or 1 themselves if the parent's own were closed.
  const int from = fcntl(input, F_DUPFD_CLOEXEC, 3), to = fcntl(fd, F_DUPFD_CLOEXEC, 3);
  dup2(from, STDIN_FILENO);
  dup2(to, STDOUT_FILENO);
  std::array<char*, 2> arguments{program.data(), nullptr};
  execv(program.c_str(), arguments.data());
  answer(std::string(1, not_started) + program + " cannot be run: " + std::strerror(errno), to);
}

// Passes `bytes` to the other end of the socket and closes it. A child that has ended reads nothing: its status tells.
void send_all(int socket, const std::string& bytes) {
  for (size_t done = 0; done < bytes.size();) {
    const ssize_t n = send(socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    done += static_cast<size_t>(n);
  }
  close(socket);
}

// Third-party readers write to stdout and stderr, which are reserved for data and messages of the tools.
void silence() {
  const int null = open("/dev/null", O_WRONLY);
  if (null < 0) return;
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  close(null);
}

[[noreturn]] void rethrow(const std::string& bytes) {
  if (bytes[0] == format_error) {
    const size_t end = bytes.find('\0', 1);
    FormatError e(bytes.substr(end + 1));
    e.rule = bytes.substr(1, end - 1);
    throw e;
  }
  if (bytes[0] == no_memory) throw std::bad_alloc();
  if (bytes[0] == not_started) throw Error(ExitCode::defect, bytes.substr(1));
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

// What a child answers that executes `body` with the descriptor to write to, while the parent executes `feed`; its exit
// status is written to `status`.
std::string answer_of_child(const std::function<void(int fd)>& body, const std::function<void()>& feed,
                            const ChildLimits& limits, int& status) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail("cannot make a pipe");
  // The child is killed with its parent, since no process would read its result.
  const pid_t child = start_child(
      [&] {
        close(ends[0]);
        limit_child(limits);
        body(ends[1]);
        return 1;
      },
      SIGKILL);
  close(ends[1]);
  feed();
  std::string bytes = read_all(ends[0]);
  close(ends[0]);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return bytes;
}

std::string result_of(const std::string& bytes, int status, const std::string& crash_message) {
  // Sanitizers turn a crash into an exit code, so everything but a clean exit counts as a crash.
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty()) throw FormatError(crash_message);
  if (bytes[0] == value) return bytes.substr(1);
  if (bytes[0] == no_memory && !has_limited_memory()) throw FormatError(crash_message);
  rethrow(bytes);
}

}  // namespace

pid_t start_child(const std::function<int()>& body, int death_signal) {
  std::signal(SIGCHLD, SIG_DFL);  // no child could be waited for if it was ignored
  std::fflush(nullptr);           // or both processes would write what is buffered
  const pid_t parent = getpid(), child = fork();
  if (child < 0) fail("cannot start a process");
  if (child > 0) return child;
  prctl(PR_SET_PDEATHSIG, death_signal);
  if (getppid() != parent) _exit(1);
  remove_signal_handlers();
  const auto work = [&]() noexcept { return body(); };  // an exception does not reach what the parent would do next
  const int code = work();
  std::fflush(nullptr);
  _exit(code);
}

std::string run_in_child(const std::function<std::string()>& work, const std::string& crash_message,
                         const ChildLimits& limits) {
  int status = 0;
  const auto body = [&](int fd) { answer(outcome_of(work), fd); };
  const auto no_input = [] {};
  const std::string bytes = answer_of_child(body, no_input, limits, status);
  return result_of(bytes, status, crash_message);
}

std::string run_program(const std::string& program, const std::string& input, const std::string& crash_message,
                        const ChildLimits& limits) {
  // Not a file in memory: a limit of the size of files (ulimit -f) holds for that too.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("cannot make a socket");
  int status = 0;
  const auto body = [&](int fd) { become(program, ends[1], fd); };
  const auto feed = [&] { close(ends[1]), send_all(ends[0], input); };
  std::string bytes = answer_of_child(body, feed, limits, status);
  if (bytes.empty()) {
    require_resources(has_limited_memory() ? ENOMEM : 0, program + " cannot be started");
    throw Error(ExitCode::defect, program + " cannot be started");
  }
  if (bytes.front() == has_started) bytes.erase(0, 1);
  return result_of(bytes, status, crash_message);
}

void answer_parent(const std::function<std::string(const std::string& input)>& work) {
  const int fd = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  write_all(fd, &has_started, 1);
  const std::string input = read_all(STDIN_FILENO);
  silence();
  answer(outcome_of([&] { return work(input); }), fd);
}

std::string helper_program(const std::string& name) {
  std::array<char, PATH_MAX> path{};
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size() - 1);
  if (length < 0) throw Defect("cannot find the program file of this process");
  const std::string self(path.data(), static_cast<size_t>(length));
  return self.substr(0, self.rfind('/')) + "/../libexec/" + name;
}

}  // namespace quadrille
