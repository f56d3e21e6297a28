#include "export/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/numbered_names.hpp"

namespace quadrille::exports {
namespace {

/// The number of each name in `distinct`, which grows by the names that are new.
std::vector<int> number(const std::vector<std::string>& names, std::vector<std::string>& distinct) {
  std::map<std::string, int> known;
  std::vector<int> numbers;
  for (const std::string& name : names) {
    const auto [entry, is_new] = known.try_emplace(name, static_cast<int>(distinct.size()));
    if (is_new) distinct.push_back(name);
    numbers.push_back(entry->second);
  }
  return numbers;
}

/// The regions of the blocks, by name.
std::vector<std::string> region_names_of(const QuadMesh& mesh) {
  std::vector<std::string> names = mesh.block_names;
  std::string domain = "domain";
  for (const int block : mesh.unnamed_blocks) names[block].clear();
  while (std::find(names.begin(), names.end(), domain) != names.end()) domain += '_';
  for (const int block : mesh.unnamed_blocks) names[block] = domain;
  return names;
}

}  // namespace

Groups mesh_groups(const QuadMesh& mesh) {
  std::vector<std::string> curve_names = mesh.face.curve_names;
  for (std::size_t curve = 0; curve < curve_names.size(); ++curve)
    if (curve_names[curve].empty()) curve_names[curve] = fmt::format("curve_{}", curve);
  Groups groups;
  groups.curve2boundary = number(curve_names, groups.boundary_names);
  groups.block2region = number(region_names_of(mesh), groups.region_names);
  groups.is_region_named.assign(groups.region_names.size(), false);
  for (std::size_t block = 0; block < groups.block2region.size(); ++block)
    if (!std::binary_search(mesh.unnamed_blocks.begin(), mesh.unnamed_blocks.end(), static_cast<int>(block)))
      groups.is_region_named[groups.block2region[block]] = true;
  return groups;
}

void separate_blocks(QuadMesh& mesh) {
  for (const int block : mesh.unnamed_blocks) mesh.block_names[block].clear();
  for (std::string& name : mesh.block_names)
    if (name == mesh.face.name) name.clear();
  replace_empty_names(mesh.block_names, "block");
  mesh.unnamed_blocks.clear();
}

}  // namespace quadrille::exports
