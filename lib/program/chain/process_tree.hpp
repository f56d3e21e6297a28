#pragma once
// A process with all that descend from it: what they use, and signals to all of them.

#include <sys/types.h>

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

}  // namespace quadrille::chain
