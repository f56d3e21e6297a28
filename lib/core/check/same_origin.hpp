#pragma once
// Whether two files belong together, by their provenance (formats/README.md, "Provenance").

#include "model/provenance.hpp"

namespace quadrille::check {

/// Whether one of the files was made from the other: the provenance chain of one contains the digest of the other.
bool have_same_origin(const FileIdentity& first, const Provenance& first_chain, const FileIdentity& second,
                      const Provenance& second_chain);

/// Throws FormatError unless one of the files was made from the other.
void require_same_origin(const FileIdentity& first, const Provenance& first_chain, const FileIdentity& second,
                         const Provenance& second_chain);

}  // namespace quadrille::check
