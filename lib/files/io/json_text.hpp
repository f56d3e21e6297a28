#pragma once
// Readable JSON text. Private to io.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace quadrille::io {

/// `value` as text: two blanks of indentation, short arrays and objects on one line, long arrays of numbers wrapped.
/// Doubles in the shortest form that reads back to the same bits, always with a point or an exponent.
std::string json_text(const nlohmann::ordered_json& value);

}  // namespace quadrille::io
