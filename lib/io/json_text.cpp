#include "io/json_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace quadrille::io {

namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t line_width = 110;

std::string quoted(const std::string& text) { return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace); }

/// The value on one line, with blanks after commas and colons.
std::string one_line(const Json& value) {
  if (!value.is_structured()) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out(1, value.is_object() ? '{' : '[');
  for (auto it = value.begin(); it != value.end(); ++it) {
    if (it != value.begin()) out += ", ";
    if (value.is_object()) out += quoted(it.key()) + ": ";
    out += one_line(it.value());
  }
  return out += value.is_object() ? '}' : ']';
}

std::string pretty(const Json& value, std::size_t indent);

/// Short items, as many on a line as fit.
std::string wrapped_items(const Json& value, std::size_t indent) {
  const std::string margin = '\n' + std::string(indent + 2, ' ');
  std::string out = "[" + margin;
  std::size_t column = indent + 2;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string item = one_line(value[i]);
    if (i > 0 && column + item.size() + 2 > line_width) {
      out += ',' + margin;
      column = indent + 2;
    } else if (i > 0) {
      out += ", ";
      column += 2;
    }
    out += item;
    column += item.size();
  }
  return out + '\n' + std::string(indent, ' ') + ']';
}

bool is_point_or_number(const Json& value) {
  return !value.is_structured() ||
         (value.is_array() && value.size() <= 4 &&
          std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_structured(); }));
}

std::string pretty(const Json& value, std::size_t indent) {
  if (!value.is_structured() || value.empty()) return one_line(value);
  // Only a leaf or a shallow structure can be short; testing the size first keeps this linear.
  if (value.size() <= 12) {
    std::string line = one_line(value);
    if (line.size() + indent <= line_width) return line;
  }
  if (value.is_array() && std::all_of(value.begin(), value.end(), is_point_or_number))
    return wrapped_items(value, indent);
  const std::string margin = '\n' + std::string(indent + 2, ' ');
  std::string out(1, value.is_object() ? '{' : '[');
  for (auto it = value.begin(); it != value.end(); ++it) {
    out += it == value.begin() ? margin : ',' + margin;
    if (value.is_object()) out += quoted(it.key()) + ": ";
    out += pretty(it.value(), indent + 2);
  }
  return out + '\n' + std::string(indent, ' ') + (value.is_object() ? '}' : ']');
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& value) {
  if (!value.is_object()) return pretty(value, 0) + '\n';
  // The top level always has a line for each key.
  std::string out = "{";
  for (auto it = value.begin(); it != value.end(); ++it)
    out += std::string(it == value.begin() ? "\n  " : ",\n  ") + quoted(it.key()) + ": " + pretty(it.value(), 2);
  return out + "\n}\n";
}

}  // namespace quadrille::io
