#include "chain/process_tree.hpp"

#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/message_text.hpp"

namespace quadrille::chain {

namespace {

// Positions of the words in /proc/PID/stat behind the name: the parent, and the first and last clock ticks of the
// process and of the children for which it has waited, in user and system mode.
constexpr std::size_t parent_position = 1, first_ticks = 11, last_ticks = 14;

// The words there; none if the process has ended.
std::vector<std::string> status_words(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text, '\0');         // unlike the file's buffer, it does not throw if the process ends meanwhile
  const auto name_end = text.rfind(')');  // a name may contain this, too
  std::istringstream rest(name_end == std::string::npos ? "" : text.substr(name_end + 1));
  return {std::istream_iterator<std::string>(rest), {}};
}

pid_t parent_of(pid_t process) {
  const auto words = status_words(process);
  return words.size() > parent_position ? std::stoi(words[parent_position]) : 0;
}

std::set<pid_t> present_processes() {
  std::set<pid_t> processes;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    if (const auto process = number_of<pid_t>(entry.path().filename().native())) processes.insert(*process);
  }
  return processes;
}

}  // namespace

void ProcessTree::update() {
  const auto present = present_processes();
  const auto has_ended = [&](pid_t process) { return !present.contains(process); };
  std::erase_if(members_, has_ended);
  std::erase_if(others_, has_ended);
  std::vector<std::pair<pid_t, pid_t>> fresh;  // process and parent
  for (const pid_t process : present)
    if (!members_.contains(process) && !others_.contains(process)) fresh.emplace_back(process, parent_of(process));
  const auto joins = [&](const auto& one) {
    return members_.contains(one.second) && members_.insert(one.first).second;
  };
  while (std::erase_if(fresh, joins) > 0) continue;
  for (const auto& [process, parent] : fresh) others_.insert(process);
}

double ProcessTree::cpu_seconds() const {
  long ticks = 0;
  for (const pid_t process : members_) {
    const auto words = status_words(process);
    for (std::size_t i = first_ticks; i <= last_ticks && i < words.size(); ++i) ticks += std::stol(words[i]);
  }
  return static_cast<double>(ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::size_t ProcessTree::memory() const {
  std::size_t kilobytes = 0;
  for (const pid_t process : members_) {
    std::ifstream file("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(file, line);)
      if (line.starts_with("VmRSS:") || line.starts_with("VmSwap:"))
        kilobytes += std::stoul(line.substr(line.find(':') + 1));
  }
  return kilobytes << 10;
}

void ProcessTree::kill(int signal) const {
  for (const pid_t process : members_) ::kill(process, signal);
}

namespace {

constexpr timespec interval{0, 20'000'000};  // between two looks at the processes

bool is_ignored(int number) {
  struct sigaction action {};
  return sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

BlockedSignals::BlockedSignals() {
  sigemptyset(&blocked_);
  sigaddset(&blocked_, SIGCHLD);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    if (!is_ignored(number)) sigaddset(&blocked_, number);
  pthread_sigmask(SIG_BLOCK, &blocked_, &before_);
}

int BlockedSignals::take() const {
  const int number = sigtimedwait(&blocked_, nullptr, &interval);
  return number > 0 && number != SIGCHLD ? number : 0;
}

void BlockedSignals::release() const { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace quadrille::chain
