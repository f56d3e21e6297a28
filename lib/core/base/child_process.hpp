#pragma once
// Child processes, and limits of processes: of resources, which a call of the system met, and of memory.

#include <sys/types.h>

#include <cstdint>
#include <functional>
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
/// The bytes that a process can have at most: those of the machine, or fewer by its limits (ulimit -v, -d).
std::uint64_t memory_limit();

/// Limits the data of this process: an allocation beyond `bytes` fails. Returns what the heap has in reserve to the
/// system where that is more than half of them. Programs that it starts may raise the limit. Nothing with sanitizers.
void limit_data(std::uint64_t bytes);

/// The stack of each thread that is started from now on: all of it counts as data, whether it is used or not.
void limit_stacks(std::size_t bytes);

// Runs work that may crash, such as third-party readers of arbitrary bytes, in a child process: a copy of this process,
// or a program with libraries that this one shall not load.

/// Starts a copy of this process, which executes `body`; its value is the exit code, an exception aborts. The copy has
/// none of this process's signal handlers, does not run its exit handlers, and gets `death_signal` when the calling
/// thread ends. Throws Defect if no process can be started.
pid_t start_child(const std::function<int()>& body, int death_signal);

/// What a child may use: CPU time, and memory beside that which it shares with its parent.
struct ChildLimits {
  int cpu_seconds = 300;
  std::uint64_t bytes = std::uint64_t{4} << 30;
};

/// Runs `work` in a forked child and returns its result. Errors of base/error.hpp thrown in the child are rethrown here
/// with their type and message. Throws FormatError with `crash_message` if the child is killed by a signal or exceeds
/// its limits, and std::bad_alloc if it runs out of memory where that of this process is limited.
std::string run_in_child(const std::function<std::string()>& work, const std::string& crash_message,
                         const ChildLimits& limits = {});

/// The same for `program`, which answers `input` with answer_parent(). Throws Error (exit 70) if it cannot be started.
std::string run_program(const std::string& program, const std::string& input, const std::string& crash_message,
                        const ChildLimits& limits = {});

/// The main function of such a program: passes standard input to `work` and its result or error to the parent.
/// Meanwhile nothing is written to standard output and standard error, whatever libraries print there.
[[noreturn]] void answer_parent(const std::function<std::string(const std::string& input)>& work);

/// The path of a program that belongs to this one: in the folder libexec beside that of this program.
std::string helper_program(const std::string& name);

}  // namespace quadrille
