#pragma once
// Runs work that may crash, such as third-party readers of arbitrary bytes, in a child process.

#include <functional>
#include <string>

namespace quadrille {

/// Runs `work` in a forked child and returns its result. Errors of base/error.hpp thrown in the child are rethrown here
/// with their type and message. Throws FormatError with `crash_message` if the child is killed by a signal, runs out of
/// memory or exceeds `cpu_seconds` of CPU time.
std::string run_in_child(const std::function<std::string()>& work, const std::string& crash_message,
                         int cpu_seconds = 300);

}  // namespace quadrille
