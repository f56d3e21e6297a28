#include "io/hdf5_library.hpp"

#include <hdf5.h>

#include <cstdlib>
#include <new>

namespace quadrille::io {

void require_memory(std::size_t bytes) {
  void* const volatile memory = std::malloc(bytes);  // volatile: a compiler may leave out what is not used
  if (memory == nullptr) throw std::bad_alloc();
  std::free(memory);
}

bool lacks_memory() {
  bool is_found = false;
  const auto look = [](unsigned, const H5E_error2_t* error, void* found) -> herr_t {
    *static_cast<bool*>(found) |= error->maj_num == H5E_RESOURCE && error->min_num == H5E_NOSPACE;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look, &is_found);
  return is_found;
}

}  // namespace quadrille::io
