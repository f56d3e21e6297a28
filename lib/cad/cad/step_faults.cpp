#include "cad/step_faults.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <string_view>
#include <vector>

namespace quadrille::cad {
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
