#include "cli/signals.hpp"

#include <csignal>

#include "base/cleanup.hpp"
#include "cli/progress_line.hpp"

namespace quadrille::cli {

namespace {

extern "C" void end_of_signal(int number) {
  remove_temporaries();
  erase_progress_line();
  // The default action is in force again (SA_RESETHAND): the signal is delivered when the handler returns.
  std::raise(number);
}

}  // namespace

void install_signal_handlers() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = end_of_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace quadrille::cli
