#pragma once
// The archive over HDF5 groups: lists are datasets, records are columns of a group. Private to io.
//
// One dataset per member, [n] or [n, width]; a ragged member `x` is the values `x` and `x_offsets` [n + 1]; records
// inside records are a group `x` of columns and `x_offsets` beside it. The group's attribute `count` is the number of
// records.

#include <memory>

#include "io/archive.hpp"
#include "io/hdf5_file.hpp"

namespace quadrille::io {

/// The group must outlive the archive.
std::unique_ptr<Archive> hdf5_archive(const Hdf5GroupWriter& group);
std::unique_ptr<Archive> hdf5_archive(const Hdf5GroupReader& group);

void write_columns(const Hdf5GroupWriter& parent, const char* name, std::size_t count, const Archive::Each& each);
void read_columns(const Hdf5GroupReader& parent, const char* name, const std::function<void(std::size_t)>& resize,
                  const Archive::Each& each);

}  // namespace quadrille::io
