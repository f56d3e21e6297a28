#pragma once
// The division of an arc with another number of intervals.

#include "growth/growth_input.hpp"

namespace quadrille::growth {

/// Divides all arcs of a chord into `count` intervals whose lengths follow those in `divisions`; layers and breaks of
/// the boundary remain ends of intervals. If equal parts of an arc compete for the last intervals, so that no choice
/// would be symmetric, the count is the next greater one with which none compete, of a few. Returns the count.
int recount_chord(const GrowthInput& input, int chord, int count, sizing::ArcDivisions& divisions);

}  // namespace quadrille::growth
