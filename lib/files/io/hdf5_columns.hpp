#pragma once
// Records as columns of an HDF5 group: one dataset per member, [n] or [n, width]; a ragged member `x` is the values
// `x` and `x_offsets` [n + 1]; records inside records are a group `x` of columns and `x_offsets` beside it.
// The group's attribute `count` is the number of records. Private to io.

#include "io/archive.hpp"
#include "io/hdf5_file.hpp"

namespace quadrille::io {

void write_columns(const Hdf5GroupWriter& parent, const char* name, std::size_t count, const Archive::Each& each);
void read_columns(const Hdf5GroupReader& parent, const char* name, const std::function<void(std::size_t)>& resize,
                  const Archive::Each& each);

}  // namespace quadrille::io
