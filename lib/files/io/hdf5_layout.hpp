#pragma once
// Whether an HDF5 file is laid out as our own writer lays files out. libhdf5 reads beyond its buffers, divides by zero
// and reserves any amount of memory for some bytes that no writer produces; a checksum proves nothing, since anybody
// can compute it. Private to io.

#include <string_view>

namespace quadrille::io {

/// Whether each structure of the image (HDF5 File Format Specification 3.0: superblock 0, groups of one leaf of a
/// version 1 B-tree, object headers 1, messages of the kinds and types that the formats use) lies inside it, is
/// referred to once, and has the size that its shape and type demand. libhdf5 reads such an image without risk, and
/// needs no more memory than its size. Linear in the size.
bool has_own_layout(std::string_view image);

}  // namespace quadrille::io
