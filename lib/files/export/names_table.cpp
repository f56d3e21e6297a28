#include "export/names_table.hpp"

#include <fmt/format.h>

#include "base/json_string.hpp"

namespace quadrille::exports {
namespace {

std::string list(const std::vector<NamedGroup>& groups) {
  std::string out;
  for (const NamedGroup& group : groups) {
    out +=
        fmt::format("{}    {{\"id\": {}, \"name\": {}", out.empty() ? "\n" : ",\n", group.id, json_string(group.name));
    if (!group.tag.empty()) out += fmt::format(", \"tag\": {}", json_string(group.tag));
    out += '}';
  }
  return out.empty() ? "[]" : fmt::format("[{}\n  ]", out);
}

std::vector<NamedGroup> numbered(const std::vector<std::string>& names, int first) {
  std::vector<NamedGroup> groups;
  for (const std::string& name : names) groups.push_back({first + static_cast<int>(groups.size()), name, {}});
  return groups;
}

}  // namespace

SideFile names_table(const std::vector<NamedGroup>& boundaries, const std::vector<NamedGroup>& regions,
                     const std::vector<NamedGroup>& interfaces) {
  const std::string between = interfaces.empty() ? "" : fmt::format("  \"interfaces\": {},\n", list(interfaces));
  return {names_table_name,
          fmt::format("{{\n  \"boundaries\": {},\n{}  \"regions\": {}\n}}\n", list(boundaries), between, list(regions))};
}

SideFile names_table(const Groups& groups, int first_boundary, int first_region) {
  return names_table(numbered(groups.boundary_names, first_boundary), numbered(groups.region_names, first_region),
                     numbered(groups.interface_names, first_boundary + groups.num_boundaries()));
}

}  // namespace quadrille::exports
