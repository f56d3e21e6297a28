#pragma once
// What readers and writers of HDF5 images know of libhdf5: where it keeps an image, and what happens without memory.
// Private to io.

#include <cstddef>

namespace quadrille::io {

/// The library looks for a file of this name, although all of it is in memory: there can be none.
constexpr const char* image_name = "/dev/null/image";

/// Bytes that libhdf5 needs beside the data: its tables and the cache of a file; in one call, buffers.
constexpr std::size_t own_memory_of_file = 8 << 20, own_memory_of_call = 4 << 20;

/// Throws std::bad_alloc if there is no such memory: libhdf5 crashes where it gets none.
void require_memory(std::size_t bytes);

/// Whether the last call of the library failed for want of memory.
bool lacks_memory();

}  // namespace quadrille::io
