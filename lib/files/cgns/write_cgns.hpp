#pragma once
// A CGNS file of a request, by the CGNS library (Mid-Level Library of the standard).

#include <string>

#include "export/cgns_request.hpp"

namespace quadrille::cgns {

/// The bytes of the file. `path`: a file that does not exist yet, in which the library writes; it is removed again.
/// Throws OutputError with the library's message.
std::string cgns_file(const exports::CgnsRequest& request, const std::string& path);

}  // namespace quadrille::cgns
