#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "io/json_archive.hpp"

namespace quadrille::io {

namespace {

constexpr std::size_t line_width = 110;

constexpr std::size_t unlimited = std::string::npos;

std::string dumped(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// Numbers and names are most of a file, and dump() allocates a buffer for each.
void append_leaf(const nlohmann::ordered_json& value, std::string& out) {
  std::array<char, 64> text{};
  char* end = nullptr;
  if (value.is_number_float() && std::isfinite(value.get<double>())) {
    end = nlohmann::detail::to_chars(text.data(), text.data() + text.size(), value.get<double>());
  } else if (value.is_number_unsigned()) {
    end = std::to_chars(text.data(), text.data() + text.size(), value.get<std::uint64_t>()).ptr;
  } else if (value.is_number_integer()) {
    end = std::to_chars(text.data(), text.data() + text.size(), value.get<std::int64_t>()).ptr;
  } else {
    out += dumped(value);
    return;
  }
  out.append(text.data(), end);
}

bool needs_no_escape(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

void append_key(const std::string& key, std::string& out) {
  if (std::all_of(key.begin(), key.end(), needs_no_escape)) {
    (out += '"') += key;
    out += "\": ";
  } else {
    out += dumped(nlohmann::ordered_json(key)) + ": ";
  }
}

/// Appends the value on one line, with blanks after commas and colons. Stops as soon as `out` is longer than `limit`.
void append_line(const nlohmann::ordered_json& value, std::string& out, std::size_t limit = unlimited) {
  if (!value.is_structured()) {
    append_leaf(value, out);
    return;
  }
  out += value.is_object() ? '{' : '[';
  for (auto it = value.begin(); it != value.end() && out.size() <= limit; ++it) {
    if (it != value.begin()) out += ", ";
    if (value.is_object()) append_key(it.key(), out);
    append_line(it.value(), out, limit);
  }
  out += value.is_object() ? '}' : ']';
}

/// Appends the value if it fits on the line.
bool append_if_short(const nlohmann::ordered_json& value, std::size_t indent, std::string& out) {
  const std::size_t before = out.size(), limit = before + line_width;
  append_line(value, out, limit);
  if (out.size() + indent <= limit) return true;
  out.resize(before);
  return false;
}

/// Short items, as many on a line as fit.
void append_wrapped(const nlohmann::ordered_json& value, std::size_t indent, std::string& out) {
  const std::string margin = '\n' + std::string(indent + 2, ' ');
  out += "[" + margin;
  std::size_t column = indent + 2;
  std::string item;
  for (std::size_t i = 0; i < value.size(); ++i) {
    item.clear();
    append_line(value[i], item);
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
  out += '\n' + std::string(indent, ' ') + ']';
}

bool is_point_or_number(const nlohmann::ordered_json& value) {
  return !value.is_structured() || (value.is_array() && value.size() <= 4 &&
                                    std::none_of(value.begin(), value.end(), [](const nlohmann::ordered_json& item) {
                                      return item.is_structured();
                                    }));
}

void append_pretty(const nlohmann::ordered_json& value, std::size_t indent, std::string& out) {
  if (!value.is_structured() || value.empty()) return append_line(value, out);
  // Only a leaf or a shallow structure can be short; testing the size first keeps this linear.
  if (value.size() <= 12 && append_if_short(value, indent, out)) return;
  if (value.is_array() && std::all_of(value.begin(), value.end(), is_point_or_number))
    return append_wrapped(value, indent, out);
  const std::string margin = '\n' + std::string(indent + 2, ' ');
  out += value.is_object() ? '{' : '[';
  for (auto it = value.begin(); it != value.end(); ++it) {
    out += it == value.begin() ? margin : ',' + margin;
    if (value.is_object()) append_key(it.key(), out);
    append_pretty(it.value(), indent + 2, out);
  }
  out += '\n' + std::string(indent, ' ') + (value.is_object() ? '}' : ']');
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& value) {
  std::string out;
  if (!value.is_object()) {
    append_pretty(value, 0, out);
    return out + '\n';
  }
  // The top level always has a line for each key.
  out = "{";
  for (auto it = value.begin(); it != value.end(); ++it) {
    out += it == value.begin() ? "\n  " : ",\n  ";
    append_key(it.key(), out);
    append_pretty(it.value(), 2, out);
  }
  return out + "\n}\n";
}

}  // namespace quadrille::io
