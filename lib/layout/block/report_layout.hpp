#pragma once
// Reports the measures of a layout: as keys of --report, and as one line of text.

#include <string>

#include "base/report.hpp"
#include "block/smallest_block.hpp"

namespace quadrille::block {

/// Reports counts, the worst measures with their positions, the smallest block and the features that force it.
void report_layout(const BlockLayout& layout, const std::vector<BlockMeasure>& measures, Report& report);

/// "12 blocks, least scaled Jacobian 0.84 (block 3 near (1, 2)), smallest block 7: a side of 0.1 near (3, 4) between
/// curve 2 and the corner of curves 5 and 6".
std::string summarise_layout(const BlockLayout& layout, const std::vector<BlockMeasure>& measures);

}  // namespace quadrille::block
