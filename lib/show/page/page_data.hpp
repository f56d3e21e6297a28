#pragma once
// The data of a page as JSON: objects with sorted-by-call keys, arrays of numbers as base64 of little-endian bytes.

#include <cstdint>
#include <string>
#include <vector>

namespace quadrille::page {

/// RFC 4648, with padding.
std::string base64(const std::string& bytes);

/// The bytes of the numbers, little-endian, as base64.
std::string packed(const std::vector<std::int32_t>& values);
std::string packed(const std::vector<std::int16_t>& values);
std::string packed(const std::vector<std::uint8_t>& values);
/// As IEEE numbers of 32 bits.
std::string packed_floats(const std::vector<double>& values);

/// `text` as a JSON string that may stand inside a <script> element: no "<", ">" or "&".
std::string script_string(const std::string& text);
/// JSON as it may stand inside a <script> element: such characters are in strings only, and are escaped there.
std::string script_json(const std::string& json);
/// `text` as the content of an HTML element or attribute.
std::string html_text(const std::string& text);

/// A JSON array of values that are JSON already.
std::string json_list(const std::vector<std::string>& values);
/// A JSON array of strings.
std::string json_texts(const std::vector<std::string>& texts);

/// The colours of drawings, light and dark.
std::string palettes_json();

// The parts of a page that do not depend on its data, compiled in from view/ (CMakeLists.txt).
std::string page_style();   ///< view/view.css
std::string page_body();    ///< view/body.html
std::string page_script();  ///< view/*.js in one function

/// A JSON object, key by key.
class JsonObject {
 public:
  JsonObject& json(const std::string& key, const std::string& value);
  JsonObject& text(const std::string& key, const std::string& value) { return json(key, script_string(value)); }
  /// Finite numbers with 17 digits; others become null.
  JsonObject& number(const std::string& key, double value);
  JsonObject& flag(const std::string& key, bool value) { return json(key, value ? "true" : "false"); }
  /// Base64, which needs no escapes.
  JsonObject& data(const std::string& key, const std::string& base64) { return json(key, '"' + base64 + '"'); }
  std::string str() const { return '{' + members_ + '}'; }

 private:
  std::string members_;
};

}  // namespace quadrille::page
