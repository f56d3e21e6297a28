#pragma once
// Regions of elements as solvers address them: all blocks without a given name are one region, "domain", or have the
// name of their region of the face.

#include <algorithm>
#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille {

/// The region of each block. "domain" is followed by as many "_" as are necessary to differ from all given names.
inline std::vector<std::string> region_of_blocks(const CadFace& face, const std::vector<int>& block_region,
                                                 std::vector<std::string> block_names,
                                                 const std::vector<int>& unnamed_blocks) {
  std::string domain = "domain";
  for (const int block : unnamed_blocks) block_names[block].clear();
  while (std::find(block_names.begin(), block_names.end(), domain) != block_names.end()) domain += '_';
  for (const int block : unnamed_blocks)
    block_names[block] = block_region.empty() ? domain : face.region_names[block_region[block]];
  return block_names;
}

}  // namespace quadrille
