#pragma once
// The archive over JSON (nlohmann-json stays in the .cpp). Private to io.

#include <memory>
#include <string>

#include "io/archive.hpp"

namespace quadrille::io {

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
  bool has(const char* name) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quadrille::io
