#pragma once
// Reports the measures of a layout, as keys of --report and as one line of text, and its smallest block with the
// features of the boundary that force it.
//
// The smallest block is the one with the shortest side: it bounds the edge length of every mesh made from the layout.
// That side runs across a chord (mesh/chords.hpp), a strip of blocks between two rails. The position of each rail is
// fixed by a feature: it runs along the boundary, or through a corner, an irregular node on the boundary or an
// irregular node inside. The feature reported is the nearest one along the rail, from the short side in both
// directions; for an irregular node inside, the boundary curve nearest to it.

#include <array>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "block/measure_blocks.hpp"

namespace quadrille::block {

struct BoundaryFeature {
  int curve = -1;          ///< at a corner: the curve that starts there
  bool is_corner = false;  ///< the joint at the start of `curve`
  Vec2 position;           ///< on the boundary, relative to the face's origin
};

struct SmallestBlock {
  int block = -1;  ///< the lowest number of blocks equal within 1e-6
  int side = 0;
  Vec2 position;  ///< the middle of the shortest side, relative to the face's origin
  /// The features of the rails through the start and the end of the side.
  std::array<BoundaryFeature, 2> between;
};

/// The block with the shortest side, and the features of the boundary between which that side lies. `measures`: of all
/// blocks. Cost: linear in the lengths of the chords beside that block.
SmallestBlock smallest_block(const BlockLayout& layout, const std::vector<BlockMeasure>& measures);

/// "curve 3 'inlet'", "curve 7 (hole 1)", "the corner of curves 2 and 3"; the number of a hole is the number of its
/// loop.
std::string name_of(const CadFace& face, const BoundaryFeature& feature);

/// Reports counts, the worst measures with their positions, the smallest block and the features that force it.
void report_layout(const BlockLayout& layout, const std::vector<BlockMeasure>& measures, Report& report);

/// "12 blocks, least scaled Jacobian 0.84 (block 3 near (1, 2)), smallest block 7: a side of 0.1 near (3, 4) between
/// curve 2 and the corner of curves 5 and 6".
std::string summarise_layout(const BlockLayout& layout, const std::vector<BlockMeasure>& measures);

}  // namespace quadrille::block
