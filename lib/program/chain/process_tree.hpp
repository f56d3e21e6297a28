#pragma once
// A process with all that descend from it: what they use, and signals to all of them.

#include <sys/types.h>

#include <csignal>
#include <cstddef>
#include <set>

namespace quadrille::chain {

class ProcessTree {
 public:
  explicit ProcessTree(pid_t root) : members_{root} {}

  const std::set<pid_t>& members() const { return members_; }
  /// Removes processes that have ended and adds new ones. Only processes that were not seen before are looked at.
  void update();
  /// A process for which its parent has waited; its id may be in use again.
  void erase(pid_t process) { members_.erase(process); }
  /// CPU seconds of all members, with the children for which they have waited.
  double cpu_seconds() const;
  /// Bytes that are resident or swapped out.
  std::size_t memory() const;
  void kill(int signal) const;

 private:
  std::set<pid_t> members_, others_;
};

// Waiting for a child process: signals that would end this process are taken one by one instead.

/// Blocks INT, TERM, HUP and QUIT, unless they are ignored, and CHLD for the calling thread, until it is destroyed.
class BlockedSignals {
 public:
  BlockedSignals();
  ~BlockedSignals() { release(); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

  /// The number of a signal that has arrived and would end this process; 0 if a child has ended, or after 20 ms.
  int take() const;
  /// What was not blocked before is not blocked any more, also in a child that was started meanwhile.
  void release() const;

 private:
  sigset_t blocked_{}, before_{};
};

}  // namespace quadrille::chain
