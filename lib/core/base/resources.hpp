#pragma once
// Limits of a process that a call of the system met.

#include <cstdint>
#include <string>

namespace quadrille {

/// Throws ComputeError if `error` (errno) says that the process has no more processes, open files or memory: "WHAT: no
/// more open files: raise their limit (ulimit -n)". Otherwise does nothing.
void require_resources(int error, const std::string& what);

/// What this process has in memory, in bytes: data, used or reserved, and pages of files.
struct MemoryUse {
  std::uint64_t data = 0, of_files = 0;
};
MemoryUse memory_use();

/// Limits the data of this process: an allocation beyond `bytes` fails. Returns what the heap has in reserve to the
/// system where that is more than half of them. Programs that it starts may raise the limit. Nothing with sanitizers.
void limit_data(std::uint64_t bytes);

/// The stack of each thread that is started from now on: all of it counts as data, whether it is used or not.
void limit_stacks(std::size_t bytes);

}  // namespace quadrille
