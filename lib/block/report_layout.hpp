#pragma once
// The measures of a layout: for programs (--report), and for people in one line.

#include <string>

#include "base/report.hpp"
#include "block/smallest_block.hpp"

namespace quadrille::block {

/// Counts, the worst measures with their places, the smallest block and what forces it.
void report_layout(const BlockLayout& layout, const std::vector<BlockMeasure>& measures, Report& report);

/// "12 blocks, least scaled Jacobian 0.84 (block 3 near (1, 2)), smallest block 7: a side of 0.1 near (3, 4) between
/// curve 2 and the corner of curves 5 and 6".
std::string summarise_layout(const BlockLayout& layout, const std::vector<BlockMeasure>& measures);

}  // namespace quadrille::block
