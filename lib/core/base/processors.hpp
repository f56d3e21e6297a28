#pragma once
// The number of processors that this process may use.

#include <string>

namespace quadrille {

/// At least 1: the processors on which the process may run (its affinity), or fewer if the quota of its control group
/// (version 2) allows less CPU time than theirs.
int available_processors();

/// The quota of a control group or of one of its parents, in processors, rounded up; 0 without a quota. `mount` is the
/// folder of all groups, `group` the path in it ("/a/b"); the quota is in the file cpu.max ("max 100000" or "150000
/// 100000": microseconds of CPU time in each period of so many microseconds). Files that are missing are no quota.
int quota_of_control_group(const std::string& mount, const std::string& group);

}  // namespace quadrille
