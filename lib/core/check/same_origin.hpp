#pragma once
// Whether two files belong together, by their provenance (formats/README.md, "Provenance").

#include "base/error.hpp"
#include "model/provenance.hpp"

namespace quadrille::check {

/// Whether one of the files was made from the other: the provenance chain of one contains the digest of the other.
bool have_same_origin(const FileIdentity& first, const Provenance& first_chain, const FileIdentity& second,
                      const Provenance& second_chain);

/// Neither file was made from the other.
struct OtherOriginError : FormatError {
  using FormatError::FormatError;
};

/// Throws OtherOriginError unless one of the files was made from the other.
void require_same_origin(const FileIdentity& first, const Provenance& first_chain, const FileIdentity& second,
                         const Provenance& second_chain);

}  // namespace quadrille::check
