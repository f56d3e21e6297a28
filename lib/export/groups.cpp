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

}  // namespace

std::vector<std::string> region_of_blocks(std::vector<std::string> block_names,
                                          const std::vector<int>& unnamed_blocks) {
  std::string domain = "domain";
  for (const int block : unnamed_blocks) block_names[block].clear();
  while (std::find(block_names.begin(), block_names.end(), domain) != block_names.end()) domain += '_';
  for (const int block : unnamed_blocks) block_names[block] = domain;
  return block_names;
}

Groups mesh_groups(const QuadMesh& mesh) {
  std::vector<std::string> curve_names = mesh.face.curve_names;
  for (std::size_t curve = 0; curve < curve_names.size(); ++curve)
    if (curve_names[curve].empty()) curve_names[curve] = fmt::format("curve_{}", curve);
  Groups groups;
  groups.curve2boundary = number(curve_names, groups.boundary_names);
  groups.block2region = number(region_of_blocks(mesh.block_names, mesh.unnamed_blocks), groups.region_names);
  groups.is_region_named.assign(groups.region_names.size(), false);
  for (std::size_t block = 0; block < groups.block2region.size(); ++block)
    if (!std::binary_search(mesh.unnamed_blocks.begin(), mesh.unnamed_blocks.end(), static_cast<int>(block)))
      groups.is_region_named[groups.block2region[block]] = true;
  return groups;
}

void separate_blocks(std::vector<std::string>& block_names, std::vector<int>& unnamed_blocks,
                     const std::string& face_name) {
  for (const int block : unnamed_blocks) block_names[block].clear();
  for (std::string& name : block_names)
    if (name == face_name) name.clear();
  replace_empty_names(block_names, "block");
  unnamed_blocks.clear();
}

}  // namespace quadrille::exports
