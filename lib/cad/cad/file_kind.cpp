#include "cad/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

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

std::string format_stem(CadFormat format) {
  return format == CadFormat::step ? "step" : format == CadFormat::iges ? "iges" : "brep";
}

CadFormat cad_format(const std::string& bytes, const std::string& name) {
  if (bytes.empty()) throw FormatError(name + ": the file is empty");
  const std::string extension = lower_extension(name);
  const auto content = format_of_content(bytes), claimed = format_of_extension(extension);
  if (!content && extension == ".fcstd")
    throw FormatError(name + ": a document of FreeCAD: select the shape there, and export it as STEP (File, Export)");
  if (!content) throw FormatError(name + ": not a CAD file: " + expected + ": export the shape as STEP");
  if (!extension.empty() && !claimed)
    throw FormatError(name + ": wrong extension " + extension + " for a " + format_name(*content) +
                      " file: " + expected);
  if (claimed && *claimed != *content)
    throw FormatError(name + ": the extension " + extension + " says " + format_name(*claimed) + ", the content is " +
                      format_name(*content));
  require_whole(*content, bytes, name);
  return *content;
}

namespace {

struct Reference {
  int argument = 0;  ///< position in the entity's list, base 0
  long long id = 0;
};

struct Entity {
  std::string type;  ///< empty for a complex one: #1 = ( A() B() )
  std::vector<Reference> references;
};

// The entity types to which an argument of an entity may refer.
struct Expectation {
  const char* type;
  int argument;
  std::vector<std::string_view> allowed;
};

const std::vector<Expectation>& expectations() {
  static const std::vector<Expectation> table = {
      {"VERTEX_POINT", 1, {"CARTESIAN_POINT"}},
      {"LINE", 1, {"CARTESIAN_POINT"}},
      {"LINE", 2, {"VECTOR"}},
      {"VECTOR", 1, {"DIRECTION"}},
      {"AXIS2_PLACEMENT_3D", 1, {"CARTESIAN_POINT"}},
      {"AXIS2_PLACEMENT_3D", 2, {"DIRECTION"}},
      {"AXIS2_PLACEMENT_3D", 3, {"DIRECTION"}},
      {"CIRCLE", 1, {"AXIS2_PLACEMENT_3D", "AXIS2_PLACEMENT_2D"}},
      {"ELLIPSE", 1, {"AXIS2_PLACEMENT_3D", "AXIS2_PLACEMENT_2D"}},
      {"PLANE", 1, {"AXIS2_PLACEMENT_3D"}},
      {"B_SPLINE_CURVE_WITH_KNOTS", 2, {"CARTESIAN_POINT"}},
      {"EDGE_CURVE", 1, {"VERTEX_POINT"}},
      {"EDGE_CURVE", 2, {"VERTEX_POINT"}},
      {"ORIENTED_EDGE", 3, {"EDGE_CURVE", "ORIENTED_EDGE", "SUBEDGE", "EDGE"}},
      {"EDGE_LOOP", 1, {"ORIENTED_EDGE"}},
      {"FACE_BOUND", 1, {"EDGE_LOOP", "POLY_LOOP", "VERTEX_LOOP"}},
      {"FACE_OUTER_BOUND", 1, {"EDGE_LOOP", "POLY_LOOP", "VERTEX_LOOP"}},
      {"ADVANCED_FACE", 1, {"FACE_BOUND", "FACE_OUTER_BOUND"}},
  };
  return table;
}

// The statements of the data section without strings, whose characters could be mistaken for syntax.
std::vector<std::string> statements(const std::string& bytes) {
  std::vector<std::string> result;
  const size_t data = bytes.find("DATA;");
  if (data == std::string::npos) return result;
  std::string statement;
  bool quoted = false;
  for (size_t i = data + 5; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (c == '\'') quoted = !quoted;
    if (quoted || c == '\'' || std::isspace(static_cast<unsigned char>(c))) continue;
    if (c != ';') {
      statement += c;
      continue;
    }
    if (statement == "ENDSEC") break;
    result.push_back(std::move(statement));
    statement.clear();
  }
  return result;
}

long long number_at(const std::string& s, size_t& i) {
  long long n = 0;
  while (i < s.size() && std::isdigit(static_cast<unsigned char>(s[i])) && n < 1000000000000LL)
    n = 10 * n + (s[i++] - '0');
  return n;
}

Entity parsed(const std::string& s, size_t i) {
  Entity entity;
  while (i < s.size() && s[i] != '(') entity.type += s[i++];
  int depth = 0, argument = 0;
  for (; i < s.size(); ++i) {
    depth += (s[i] == '(') - (s[i] == ')');
    if (s[i] == ',' && depth == 1) ++argument;
    if (s[i] != '#') continue;
    const long long id = number_at(s, ++i);
    --i;
    entity.references.push_back({argument, id});
  }
  return entity;
}

std::map<long long, Entity> entities(const std::string& bytes) {
  std::map<long long, Entity> result;
  for (const std::string& s : statements(bytes)) {
    if (s.empty() || s[0] != '#') continue;
    size_t i = 1;
    const long long id = number_at(s, i);
    if (i < s.size() && s[i] == '=') result[id] = parsed(s, i + 1);
  }
  return result;
}

bool is_allowed(const Expectation& e, const std::string& type) {
  for (const std::string_view allowed : e.allowed)
    if (allowed == type) return true;
  return false;
}

}  // namespace

std::string step_fault(const std::string& bytes) {
  const auto all = entities(bytes);
  for (const auto& [id, entity] : all)
    for (const Reference& reference : entity.references) {
      const std::string name = fmt::format("#{} {}", id, entity.type);
      const auto target = all.find(reference.id);
      if (target == all.end()) return fmt::format("{} refers to #{}, which is not in the file", name, reference.id);
      if (target->second.type.empty()) continue;
      for (const Expectation& e : expectations())
        if (entity.type == e.type && reference.argument == e.argument && !is_allowed(e, target->second.type))
          return fmt::format("{} refers to #{}, which is of type {}, not {}", name, reference.id, target->second.type,
                             e.allowed.front());
    }
  return {};
}

}  // namespace quadrille::cad
