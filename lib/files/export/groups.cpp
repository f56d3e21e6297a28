#include "export/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/assign_names.hpp"

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

/// Those on the boundary first.
void number_curves(const std::vector<std::string>& names, const std::vector<bool>& is_inner, Groups& groups) {
  std::vector<std::string> boundaries, all;
  for (std::size_t c = 0; c < names.size(); ++c)
    if (!is_inner[c]) boundaries.push_back(names[c]);
  number(boundaries, groups.boundary_names);
  boundaries = groups.boundary_names;
  boundaries.insert(boundaries.end(), names.begin(), names.end());
  const std::vector<int> numbers = number(boundaries, all);
  groups.curve2boundary.assign(numbers.begin() + groups.num_boundaries(), numbers.end());
  groups.interface_names.assign(all.begin() + groups.num_boundaries(), all.end());
}

}  // namespace

std::vector<bool> inner_curves(const QuadMesh& mesh) {
  std::vector<bool> is_inner(mesh.face.curves.size(), false);
  for (const QuadBoundaryEdge& edge : mesh.interface_edges) is_inner[edge.curve] = true;
  return is_inner;
}

std::vector<QuadBoundaryEdge> interface_edges_once(const QuadMesh& mesh) {
  std::vector<QuadBoundaryEdge> edges = mesh.interface_edges;
  std::erase_if(edges, [&](const QuadBoundaryEdge& edge) { return edge.curve > mesh.face.partners[edge.curve]; });
  return edges;
}

std::vector<std::string> region_of_blocks(const CadFace& face, const std::vector<int>& block_region,
                                          std::vector<std::string> block_names,
                                          const std::vector<int>& unnamed_blocks) {
  std::string domain = "domain";
  for (const int block : unnamed_blocks) block_names[block].clear();
  while (std::find(block_names.begin(), block_names.end(), domain) != block_names.end()) domain += '_';
  for (const int block : unnamed_blocks)
    block_names[block] = block_region.empty() ? domain : face.region_names[block_region[block]];
  return block_names;
}

Groups mesh_groups(const QuadMesh& mesh) {
  std::vector<std::string> curve_names = mesh.face.curve_names;
  for (std::size_t curve = 0; curve < curve_names.size(); ++curve)
    if (curve_names[curve].empty()) curve_names[curve] = fmt::format("curve_{}", curve);
  Groups groups;
  number_curves(curve_names, inner_curves(mesh), groups);
  groups.block2region = number(region_of_blocks(mesh), groups.region_names);
  groups.is_region_named.assign(groups.region_names.size(), false);
  for (std::size_t block = 0; block < groups.block2region.size(); ++block)
    if (!std::binary_search(mesh.unnamed_blocks.begin(), mesh.unnamed_blocks.end(), static_cast<int>(block)))
      groups.is_region_named[groups.block2region[block]] = true;
  return groups;
}

void separate_blocks(const CadFace& face, const std::vector<int>& block_region, std::vector<std::string>& block_names,
                     std::vector<int>& unnamed_blocks) {
  for (const int block : unnamed_blocks) block_names[block].clear();
  for (std::size_t block = 0; block < block_names.size(); ++block) {
    const std::string& common = block_region.empty() ? face.name : face.region_names[block_region[block]];
    if (block_names[block] == common) block_names[block].clear();
  }
  replace_empty_names(block_names, "block");
  unnamed_blocks.clear();
}

}  // namespace quadrille::exports
