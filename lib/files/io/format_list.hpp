#pragma once
// The table of formats and stages for scripts (formats/README.md, "The table of formats").

#include <string>

namespace quadrille::io {

/// A JSON object of the lists `formats`, `tools` and `optional_inputs`, a row of the table on each line.
std::string format_list();

}  // namespace quadrille::io
