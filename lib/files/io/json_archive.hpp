#pragma once
// The archive over JSON, and readable JSON text (nlohmann-json stays in the sources). Private to io.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/archive.hpp"

namespace quadrille::io {

/// Whether the text has no more than 100 levels of brackets, since printing a value recurses and a file that consists
/// of brackets must not exhaust the stack, and no object of more than 10,000 keys, since each is compared with the
/// others.
bool is_shallow(const std::string& json);
/// Throws FormatError unless it is.
void require_shallow(const std::string& json, const std::string& file_name);

/// Collects a JSON object and prints it.
class JsonWriter {
 public:
  JsonWriter();
  ~JsonWriter();
  Archive& root();
  std::string text() const;       ///< readable, several lines
  std::string flat_text() const;  ///< one line without blanks

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Parses an object. Throws FormatError: not JSON, not an object, a number out of range.
class JsonReader {
 public:
  JsonReader(const std::string& bytes, const std::string& file_name);
  ~JsonReader();
  Archive& root();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// `value` as text: two blanks of indentation, short arrays and objects on one line, long arrays of numbers wrapped.
/// Doubles in the shortest form that reads back to the same bits, always with a point or an exponent.
std::string json_text(const nlohmann::ordered_json& value);

}  // namespace quadrille::io
