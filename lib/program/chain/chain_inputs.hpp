#pragma once
// What a run reads: the shape, from which it makes triangles, and files by which users prescribe names and sizes.

#include <optional>

#include "chain/chain_state.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

/// Runs points2step or drawing2step if the shape is no CAD file (shape_converters), and cad2tri. Throws ChainFailure.
void triangulate_shape(ChainState& chain);

/// What a file contains, with its identity; nothing without a file.
template <typename Content>
struct Prescribed {
  Content content;
  std::optional<FileIdentity> file = std::nullopt;

  /// For a stage; this must outlive it.
  std::optional<stage::Input<Content>> input() const {
    if (!file) return std::nullopt;
    return std::optional<stage::Input<Content>>(std::in_place, content, *file);
  }
};

using Names = Prescribed<std::vector<NameRule>>;
using PrescribedSizes = Prescribed<SizeSources>;
using PrescribedMetric = Prescribed<GivenMetric>;
using SpacePoints = Prescribed<stage::PointList>;
using Directions = Prescribed<GivenAlignment>;

/// The files that the options name, "-" standard input. All throw FormatError.
Names boundary_names(const ChainState& chain);
Names block_names(const ChainState& chain);
PrescribedSizes prescribed_sizes(const ChainState& chain);
/// With positions relative to face.origin.
PrescribedMetric prescribed_metric(const ChainState& chain, const CadFace& face);
SpacePoints space_points(const ChainState& chain, const std::string& path);
Directions directions_to_align_with(const ChainState& chain, const CadFace& face);

/// A file, or what was read from standard input before.
io::InputFile read_input(const ChainState& chain, const std::string& path);

}  // namespace quadrille::chain
