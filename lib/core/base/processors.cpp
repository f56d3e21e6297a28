#include "base/processors.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <thread>

namespace quadrille {

namespace {

int processors_of_affinity() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
  return static_cast<int>(std::thread::hardware_concurrency());  // more processors than fit into a set; 0: unknown
}

/// Of /proc/self/cgroup: the line "0::/path" is that of version 2.
std::string own_control_group() {
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("0::/")) return line.substr(3);
  return "/";
}

}  // namespace

int quota_of_control_group(const std::string& mount, const std::string& group) {
  int least = 0;
  for (std::string path = group;; path.resize(path.rfind('/'))) {
    double quota = 0, period = 0;
    std::ifstream file(mount + path + "/cpu.max");  // "max" is no number: there is no quota then
    if (file >> quota >> period && quota > 0 && period > 0) {
      const int processors = static_cast<int>(std::ceil(std::min(quota / period, 1e6)));
      least = least == 0 ? processors : std::min(least, processors);
    }
    if (path.find('/') == std::string::npos) return least;
  }
}

int available_processors() {
  const int allowed = std::max(1, processors_of_affinity());
  const int quota = quota_of_control_group("/sys/fs/cgroup", own_control_group());
  return quota > 0 ? std::min(allowed, quota) : allowed;
}

}  // namespace quadrille
