#pragma once
// Quality measures of a block: as one quad of order 8, and by its exact map.
//
// The quad interpolates the exact map (mesh/transfinite.hpp) in the Gauss-Lobatto-Legendre points. For long thin and
// strongly bent blocks it may be invalid although the exact map is valid; `divisions` distinguishes the two cases.

#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "curve/chain.hpp"
#include "mesh/transfinite.hpp"
#include "model/block_layout.hpp"

namespace quadrille::block {

/// The exact maps of a layout's blocks.
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

struct BlockMeasure {
  double jacobian_bound = 0;      ///< least Bernstein bound of det J of the quad, length^2 (spectral/quad_map.hpp)
  double scaled_jacobian = 0;     ///< least sampled scaled Jacobian of the quad, -1 if det J <= 0
  Vec2 scaled_jacobian_position;  ///< its position, relative to the face's origin
  double boundary_distance = 0;   ///< greatest distance of the quad's boundary sides from their CAD curves, length
  Vec2 boundary_distance_position;
  /// The block is proved valid when its exact map is cut into n x n equal quads of order 8, n = 1, 2, 4, 8 or 16 the
  /// least such number; 0 if no such number is found: the exact map folds, or nearly so.
  int divisions = 0;
  double map_scaled_jacobian = -1;  ///< the least scaled Jacobian of those n^2 quads; -1 if divisions is 0
  double area = 0;                  ///< length^2
  double shortest_side = 0;         ///< length
  int shortest_side_index = 0;      ///< 0 to 3; the first of sides equal within 1e-6
};

/// A layout and the measures of its blocks.
struct Blocks {
  BlockLayout layout;
  std::vector<BlockMeasure> measures;
};

/// The measures of a layout's blocks. `known`: those before chords were split (block/make_blocks.hpp, split_chord);
/// blocks that were not cut keep theirs.
std::vector<BlockMeasure> measure_blocks(const BlockLayout& layout, Progress* progress = nullptr,
                                         const Blocks& known = {});

/// Copies the measures that the file contains into the layout.
void store_measures(const std::vector<BlockMeasure>& measures, BlockLayout& layout);

}  // namespace quadrille::block
