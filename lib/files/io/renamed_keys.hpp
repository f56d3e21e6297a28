#pragma once
// Reading a file of the previous major version: the same members, some of them by their former names. Private to io.

#include <span>

#include "io/archive.hpp"

namespace quadrille::io {

/// A member that had another name in the previous major version.
struct RenamedKey {
  const char* key;     ///< present names from the root, "certificate.method"; records count as objects
  const char* former;  ///< the last name before, "way"
};

/// Runs `describe` on `archive` with present names, while the file has the former ones. Messages use the names of the
/// file.
void describe_with_former_names(Archive& archive, std::span<const RenamedKey> renamed,
                                const std::function<void(Archive&)>& describe);

}  // namespace quadrille::io
