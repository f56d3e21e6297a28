#pragma once
// The exact maps of a layout's blocks.

#include <vector>

#include "curve/chain.hpp"
#include "mesh/transfinite.hpp"
#include "model/block_layout.hpp"

namespace quadrille::block {

class BlockMaps {
 public:
  /// `layout` must outlive it, and its arcs and splines must not change.
  explicit BlockMaps(const BlockLayout& layout);
  const curve::Chain& arc(int a) const { return chains_[a]; }
  mesh::TransfiniteMap map(int block) const;

 private:
  const BlockLayout* layout_;
  curve::CurveTable table_;
  std::vector<curve::Chain> chains_;
};

}  // namespace quadrille::block
