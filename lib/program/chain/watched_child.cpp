#include "chain/watched_child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "chain/process_tree.hpp"
#include "cli/messages.hpp"

namespace quadrille::chain {

namespace {

using Clock = Budget::Clock;

constexpr int not_started = 127;  // exit code of a command that cannot be started, as in shells

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// How a child ended, without its elapsed seconds; nothing while it runs.
std::optional<ChildEnd> end_of(pid_t child, int options) {
  int status = 0;
  rusage usage{};
  pid_t ended = 0;
  while ((ended = wait4(child, &status, options, &usage)) < 0 && errno == EINTR) continue;
  if (ended == 0) return std::nullopt;
  return ChildEnd{.code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
                  .cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime),
                  .memory = static_cast<std::size_t>(usage.ru_maxrss) << 10};
}

// Ends all processes of the tree; those that need longer than the grace cannot clean up. Returns the CPU seconds that
// they have used, also those for which their parents no longer wait.
double end_all(ProcessTree& tree, pid_t child, double grace, const BlockedSignals& signals) {
  tree.update();
  const double cpu = tree.cpu_seconds();
  tree.kill(SIGTERM);
  const auto start = Clock::now();
  std::optional<ChildEnd> end;
  while (!(end = end_of(child, WNOHANG)) && seconds_since(start) < grace) signals.take();
  if (end) tree.erase(child);
  tree.update();
  tree.kill(SIGKILL);
  if (!end) end = end_of(child, 0);
  return std::max(cpu, end->cpu_seconds);
}

// Waits until the child ends, or has to; `look` is called every 20 ms. Writes the signal that arrived here to `signal`.
ChildEnd watch(pid_t child, const Budget& budget, Share share, const BlockedSignals& signals,
               const std::function<void()>& look, int& signal) {
  ProcessTree tree(child);
  for (;;) {
    signal = signals.take();
    look();
    if (auto end = end_of(child, WNOHANG)) return *end;
    const double grace = budget.limits().grace;
    if (signal != 0) return {.code = 128 + signal, .cpu_seconds = end_all(tree, child, grace, signals)};
    if (!budget.is_limited()) continue;
    tree.update();
    if (auto reason = budget.reason_to_stop(share, &tree))
      return {.code = stopped_code, .cpu_seconds = end_all(tree, child, grace, signals), .stopped = std::move(reason)};
  }
}

ChildEnd start_and_watch(const std::function<int()>& body, const Budget& budget, Share share,
                         const std::function<void()>& look) {
  int signal = 0;
  ChildEnd end;
  {
    const BlockedSignals signals;
    const auto released_body = [&] { return signals.release(), body(); };
    end = watch(start_child(released_body, SIGTERM), budget, share, signals, look, signal);
  }
  if (signal != 0) std::raise(signal);
  return end;
}

ChildEnd run_looking(const std::function<int()>& body, Budget& budget, Share share, const std::function<void()>& look) {
  const auto start = Clock::now();
  ChildEnd end;
  end.stopped = budget.reason_to_stop(share, nullptr);
  if (end.stopped)
    end.code = stopped_code;
  else
    end = start_and_watch(body, budget, share, look);
  end.wall_seconds = seconds_since(start);
  budget.add_run({end.cpu_seconds, end.wall_seconds});
  return end;
}

// What is written to its descriptor `input` can be read without waiting.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) == 0) {
      fcntl(ends_[0], F_SETFL, O_NONBLOCK);
      return;
    }
    require_resources(errno, "cannot make a pipe");
    throw Defect(std::string("cannot make a pipe: ") + std::strerror(errno));
  }
  ~Pipe() { close(ends_[0]), close(ends_[1]); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int input() const { return ends_[1]; }
  void append_to(std::string& text) const {
    std::array<char, 4096> buffer{};
    for (ssize_t n = 0; (n = read(ends_[0], buffer.data(), buffer.size())) > 0;)
      text.append(buffer.data(), static_cast<std::size_t>(n));
  }

 private:
  std::array<int, 2> ends_{};
};

// Becomes a command; returns its exit code if that is impossible.
int become(std::vector<std::string> words, int input, int errors) {
  std::signal(SIGXFSZ, SIG_DFL);  // which cli ignores
  dup2(input, STDIN_FILENO);
  dup2(errors, STDERR_FILENO);
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments.front(), arguments.data());
  cli::print_message(words.front() + " cannot be started: " + std::strerror(errno) + '\n');
  return not_started;
}

}  // namespace

ChildEnd run_child(const std::function<int()>& body, Budget& budget, Share share) {
  return run_looking(body, budget, share, [] {});
}

ChildEnd run_command(const std::vector<std::string>& words, const Streams& streams, Budget& budget, Share share) {
  if (!streams.errors) return run_child([&] { return become(words, streams.input, STDERR_FILENO); }, budget, share);
  const Pipe pipe;
  const auto look = [&] { pipe.append_to(*streams.errors); };
  auto end = run_looking([&] { return become(words, streams.input, pipe.input()); }, budget, share, look);
  look();
  return end;
}

namespace {

// Signals of a crash, or of a system without memory.
constexpr std::array crashes{SIGKILL, SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};

bool has_crashed(int status) {
  return WIFSIGNALED(status) && std::find(crashes.begin(), crashes.end(), WTERMSIG(status)) != crashes.end();
}

void empty_folder(const std::string& folder) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) remove_all(entry.path(), error);
}

// The status of a worker that has ended. Writes a signal that arrived here to `taken`, and passes it on.
int status_of_work(const std::function<int()>& work, const BlockedSignals& signals, int& taken) {
  const auto released_work = [&] { return signals.release(), work(); };
  const pid_t worker = start_child(released_work, SIGTERM);
  int status = 0;
  while (waitpid(worker, &status, WNOHANG) == 0)
    if (const int number = signals.take(); number != 0) kill(worker, taken = number);
  return status;
}

// Ends what a killed copy left behind: descendants become children of a subreaper.
void end_orphans(const BlockedSignals& signals) {
  constexpr int most_waits = 50;  // of 20 ms, in which a process can remove its temporary files
  ProcessTree tree(getpid());
  for (int wait = 0; waitpid(-1, nullptr, WNOHANG) >= 0; ++wait) {
    tree.update();
    tree.erase(getpid());
    tree.kill(wait < most_waits ? SIGTERM : SIGKILL);
    signals.take();
  }
}

}  // namespace

int supervise(const std::function<int(bool is_second_try)>& work, const std::function<std::string()>& make_scratch) {
  const BlockedSignals signals;
  const std::string scratch_folder = make_scratch();
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  int taken = 0;
  int status = status_of_work([&] { return work(false); }, signals, taken);
  end_orphans(signals);
  if (taken == 0 && has_crashed(status)) {
    empty_folder(scratch_folder);
    status = status_of_work([&] { return work(true); }, signals, taken);
    end_orphans(signals);
  }
  std::error_code error;
  std::filesystem::remove_all(scratch_folder, error);
  if (taken == 0 && WIFEXITED(status)) return WEXITSTATUS(status);
  const int number = taken != 0 ? taken : WTERMSIG(status);
  std::signal(number, SIG_DFL);
  signals.release();
  std::raise(number);
  return 128 + number;
}

}  // namespace quadrille::chain
