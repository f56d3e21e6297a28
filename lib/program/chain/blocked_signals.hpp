#pragma once
// Waiting for a child process: signals that would end this process are taken one by one instead.

#include <csignal>

namespace quadrille::chain {

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
