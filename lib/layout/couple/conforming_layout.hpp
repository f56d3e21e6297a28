#pragma once
// The conforming layout of the joined regions of a face: lines continue across interfaces and periodic sides
// (lib/method.md §11).

#include "base/report.hpp"
#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// `joined`: the layout of the whole (couple/join_layouts.hpp). Lines that end near the image of an end on the other
/// one of two periodic sides are bent to match (couple/match_line_ends.hpp). Where one side has a node, and where a
/// periodic side ends, the other side gets a T-junction. A layout with T-junctions is a T-mesh: integer lengths are
/// found for it, with one for an arc and its image, and every line continues across interfaces and periodic sides
/// (quantize/quantize_and_extend.hpp). If there are no lengths, line ends on periodic sides between which every integer
/// grid has no length are bent to match. Reports couple.periodic_*. Throws ComputeError if there are no integer
/// lengths.
graph::CandidateLayout conforming_layout(const RegionLayouts& regions, graph::CandidateLayout joined, Report& report);

}  // namespace quadrille::couple
