#include "export/cgns_words.hpp"

#include <array>
#include <cctype>
#include <utility>

namespace quadrille::exports {

namespace {

/// Names in a CGNS file have at most 32 characters; elements and boundaries of one zone share none.
constexpr std::size_t longest_name = 32;

/// The type of a boundary by the beginning of its name, in upper or lower case.
const char* boundary_type(std::string name) {
  constexpr std::array<std::pair<const char*, const char*>, 7> types{{{"wall", "BCWall"},
                                                                      {"symmetry", "BCSymmetryPlane"},
                                                                      {"farfield", "BCFarfield"},
                                                                      {"inlet", "BCInflow"},
                                                                      {"inflow", "BCInflow"},
                                                                      {"outlet", "BCOutflow"},
                                                                      {"outflow", "BCOutflow"}}};
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& [beginning, type] : types)
    if (name.starts_with(beginning)) return type;
  return "UserDefined";
}

}  // namespace

PlainNames family_names(const Groups& groups, Exported& exported) {
  NameList all = groups.boundary_names;
  all.insert(all.end(), groups.region_names.begin(), groups.region_names.end());
  const WordRules rules{{}, longest_name, false};
  const NameList words = plain_names(all, rules);
  const auto middle = words.begin() + groups.num_boundaries();
  PlainNames names{{words.begin(), middle}, {middle, words.end()}};
  exported.add_loss(renamed_loss(all, words, rules));
  if (words != all) exported.side_files.push_back(names_table(groups, names.boundaries, names.regions));
  return names;
}

std::vector<CgnsFamily> families(const Groups& groups, const PlainNames& words, int num_boundaries) {
  std::vector<CgnsFamily> all;
  for (int b = 0; b < num_boundaries; ++b)
    all.push_back({words.boundaries[b], boundary_type(groups.boundary_names[b])});
  for (const std::string& region : words.regions) all.push_back({region, ""});
  return all;
}

}  // namespace quadrille::exports
