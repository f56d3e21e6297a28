#include "chain/supervisor.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "base/child_process.hpp"
#include "chain/blocked_signals.hpp"
#include "chain/process_tree.hpp"

namespace quadrille::chain {
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
