#pragma once
// Work that may crash, in a child process: third-party readers fed with arbitrary bytes.

#include <functional>
#include <string>

namespace quadrille {

/// Runs `work` in a forked child and returns the bytes that it returns. Errors of base/error.hpp thrown in the child
/// are rethrown here with their type and message; a child that dies of a signal, runs out of memory or exceeds
/// `cpu_seconds` raises FormatError with `crash_message`.
std::string run_in_child(const std::function<std::string()>& work, const std::string& crash_message,
                         int cpu_seconds = 300);

}  // namespace quadrille
