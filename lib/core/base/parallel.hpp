#pragma once
// Loops over independent pieces of work, on one thread or several, and the number of processors for them.
//
// The partition does not depend on the number of threads, and each piece writes to its own slot, so the results are the
// same bytes for every number of threads.

#include <functional>
#include <string>

namespace quadrille {

/// Calls f(i) once for each i in [0, n), on up to `num_threads` threads, the calling one included. If calls throw, the
/// exception of the lowest such i is rethrown after all threads have ended; calls for higher i may be missing.
void parallel_for(int n, int num_threads, const std::function<void(int)>& f);

/// From now on, parallel_for works on the calling thread alone until this process has used `cpu_seconds` of CPU time,
/// and in each loop until that has lasted some time for each further thread, so that work which is done sooner does not
/// pay for the start of threads: by default, what most runs take. Without this call, loops start all threads at once.
/// Not to be called while a loop runs.
void start_threads_after(double cpu_seconds = 0.2);

/// At least 1: the processors on which the process may run (its affinity), or fewer if the quota of its control group
/// (version 2) allows less CPU time than theirs.
int available_processors();

/// The quota of a control group or of one of its parents, in processors, rounded up; 0 without a quota. `mount` is the
/// folder of all groups, `group` the path in it ("/a/b"); the quota is in the file cpu.max ("max 100000" or "150000
/// 100000": microseconds of CPU time in each period of so many microseconds). Files that are missing are no quota.
int quota_of_control_group(const std::string& mount, const std::string& group);

}  // namespace quadrille
