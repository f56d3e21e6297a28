#pragma once
// How far straight sides of elements may be away from walls with layers, and from the lines on which layers go on.
//
// Layers are as thin on the sides of blocks that continue a wall, such as the line behind a trailing edge. Where a
// straight side of an element is several layers away from the curve, cells are skew.

#include <vector>

#include "layers/wall_spec.hpp"
#include "sizing/make_size_field.hpp"
#include "sizing/measured_layout.hpp"

namespace quadrille::layers {

/// For the sides of all blocks at which chords with layers begin or end: `part` of the least height of their first
/// layers. Heights must be known (set_first_heights). Throws UsageError for names that no boundary has.
std::vector<sizing::SagLimit> wall_sags(const sizing::MeasuredLayout& measured, const std::vector<WallSpec>& specs,
                                        double part);

}  // namespace quadrille::layers
