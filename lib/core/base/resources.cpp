#include "base/resources.hpp"

#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>

#include "base/error.hpp"

namespace quadrille {

void require_resources(int error, const std::string& what) {
  const char* resource = nullptr;
  if (error == EAGAIN) resource = "no more processes: raise their limit (ulimit -u)";
  if (error == EMFILE || error == ENFILE) resource = "no more open files: raise their limit (ulimit -n)";
  if (error == ENOMEM) resource = "no more memory: raise its limit (ulimit -v)";
  if (resource != nullptr) throw ComputeError(what + ": " + resource);
}

MemoryUse memory_use() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  file >> size >> resident >> shared >> text >> library >> data;
  const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return {data * page, shared * page};
}

void limit_data([[maybe_unused]] std::uint64_t bytes) {
#ifndef QUADRILLE_SANITIZE  // whose own data would count
  if (memory_use().data > bytes / 2) malloc_trim(0);
  rlimit limit{};
  getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

void limit_stacks(std::size_t bytes) {
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return;
  pthread_attr_setstacksize(&attributes, bytes);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

}  // namespace quadrille
