#include "base/resources.hpp"

#include <cerrno>

#include "base/error.hpp"

namespace quadrille {

void require_resources(int error, const std::string& what) {
  const char* resource = nullptr;
  if (error == EAGAIN) resource = "no more processes: raise their limit (ulimit -u)";
  if (error == EMFILE || error == ENFILE) resource = "no more open files: raise their limit (ulimit -n)";
  if (error == ENOMEM) resource = "no more memory: raise its limit (ulimit -v)";
  if (resource != nullptr) throw ComputeError(what + ": " + resource);
}

}  // namespace quadrille
