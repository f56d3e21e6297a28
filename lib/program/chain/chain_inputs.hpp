#pragma once
// What a run reads: the shape, from which it makes triangles, and files by which users prescribe names and sizes.

#include "chain/chain_state.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

/// Runs points2step or drawing2step if the shape is no CAD file (shape_converters), and cad2tri. Throws ChainFailure.
void triangulate_shape(ChainState& chain);

/// The files that the options name, "-" standard input. All throw FormatError.
stage::Prescribed<std::vector<NameRule>> boundary_names(const ChainState& chain);
stage::Prescribed<std::vector<NameRule>> block_names(const ChainState& chain);
stage::Prescribed<SizeSources> prescribed_sizes(const ChainState& chain);
stage::Prescribed<GivenMetric> prescribed_metric(const ChainState& chain);
stage::Prescribed<stage::PointList> space_points(const ChainState& chain, const std::string& path);
stage::Prescribed<GivenAlignment> directions_to_align_with(const ChainState& chain);

/// A file, or what was read from standard input before.
io::InputFile read_input(const ChainState& chain, const std::string& path);

}  // namespace quadrille::chain
