#pragma once
// The archive over HDF5 groups: lists are datasets, records are groups of columns. Private to io.

#include <memory>

#include "io/archive.hpp"
#include "io/hdf5_file.hpp"

namespace quadrille::io {

/// The group must outlive the archive.
std::unique_ptr<Archive> hdf5_archive(const Hdf5GroupWriter& group);
std::unique_ptr<Archive> hdf5_archive(const Hdf5GroupReader& group);

}  // namespace quadrille::io
