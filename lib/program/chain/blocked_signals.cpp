#include "chain/blocked_signals.hpp"

#include <initializer_list>

namespace quadrille::chain {
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
