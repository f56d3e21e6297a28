#pragma once
// The shortest part of the boundary between two places at which every mesh must have vertices.

#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

/// The least length of the boundary between two consecutive corners of the layout, or joints of different names
/// (sizing/name_joints); infinity if there are none. Elements there have a side as short as that at any size.
double shortest_kept_edge(const sizing::MeasuredLayout& measured);

}  // namespace quadrille::refine
