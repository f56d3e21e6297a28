#pragma once
// The exact maps of a layout's blocks.

#include <optional>
#include <vector>

#include "curve/chain.hpp"
#include "mesh/transfinite.hpp"
#include "model/block_layout.hpp"

namespace quadrille::block {

class BlockMaps {
 public:
  /// `layout` must outlive it, and its arcs and splines must not change.
  explicit BlockMaps(const BlockLayout& layout);
  /// Constructed by the first call; not for several threads at once.
  const curve::Chain& arc(int a) const;
  mesh::TransfiniteMap map(int block) const;

 private:
  const BlockLayout* layout_;
  curve::CurveTable table_;
  mutable std::vector<std::optional<curve::Chain>> chains_;
};

}  // namespace quadrille::block
