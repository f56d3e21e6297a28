#include "cad/file_kind.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include "base/error.hpp"

namespace quadrille::cad {
namespace {

const char* const expected = "expected STEP (.step, .stp, .p21), IGES (.iges, .igs) or BREP (.brep, .brp)";

std::string lower_extension(const std::string& name) {
  const std::string file = name.substr(name.find_last_of('/') + 1);
  const size_t dot = file.find_last_of('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == file.size()) return {};
  std::string extension = file.substr(dot);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::optional<CadFormat> format_of_extension(const std::string& extension) {
  if (extension == ".step" || extension == ".stp" || extension == ".p21") return CadFormat::step;
  if (extension == ".iges" || extension == ".igs") return CadFormat::iges;
  if (extension == ".brep" || extension == ".brp") return CadFormat::brep;
  return std::nullopt;
}

// An IGES file has 80 columns per line; column 73 of the first line marks the start section, columns 74 to 80 contain
// the line number.
bool looks_like_iges(std::string_view text) {
  if (text.size() < 80) return false;
  const std::string_view number = text.substr(73, 7);
  return text[72] == 'S' && number.find_first_not_of(" 01") == std::string_view::npos && number.back() == '1';
}

std::optional<CadFormat> format_of_content(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  if (looks_like_iges(text)) return CadFormat::iges;
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.substr(0, 12) == "ISO-10303-21") return CadFormat::step;
  const std::string_view head = text.substr(0, 200);
  for (const char* mark : {"DBRep_DrawableShape", "CASCADE Topology V", "Open CASCADE Topology V"})
    if (head.find(mark) != std::string_view::npos) return CadFormat::brep;
  return std::nullopt;
}

void require_whole(CadFormat format, const std::string& bytes, const std::string& name) {
  if (format == CadFormat::step && bytes.find("END-ISO-10303-21") == std::string::npos)
    throw FormatError(name + ": the STEP file is truncated: its end mark END-ISO-10303-21 is missing");
  if (format != CadFormat::iges) return;
  const size_t last = bytes.find_last_not_of(" \t\r\n\0");
  const size_t line = last == std::string::npos ? 0 : bytes.rfind('\n', last);
  const std::string end = bytes.substr(line == std::string::npos ? 0 : line + 1);
  if (end.size() < 73 || end[72] != 'T')
    throw FormatError(name + ": the IGES file is truncated: its last line is no terminate section");
}

}  // namespace

std::string format_name(CadFormat format) {
  return format == CadFormat::step ? "STEP" : format == CadFormat::iges ? "IGES" : "BREP";
}

CadFormat cad_format(const std::string& bytes, const std::string& name) {
  if (bytes.empty()) throw FormatError(name + ": the file is empty");
  const std::string extension = lower_extension(name);
  const auto content = format_of_content(bytes), claimed = format_of_extension(extension);
  if (!content) throw FormatError(name + ": not a CAD file: " + expected);
  if (!extension.empty() && !claimed)
    throw FormatError(name + ": wrong extension " + extension + " for a " + format_name(*content) +
                      " file: " + expected);
  if (claimed && *claimed != *content)
    throw FormatError(name + ": the extension " + extension + " says " + format_name(*claimed) + ", the content is " +
                      format_name(*content));
  require_whole(*content, bytes, name);
  return *content;
}

}  // namespace quadrille::cad
