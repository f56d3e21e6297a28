#pragma once
// Parameters of arcs such that the lines across a chord are nearly normal to its arcs.
//
// Equal arc-length fractions skew the elements of a block that bends one way and back: its sides are equally long, but
// each runs ahead of the other on a part of it. For neighbouring arcs a, b of a chord let d(u) be the part along the
// chord of the step from a to b at parameter u, w(u) its length, and d* the linear function with d's values at both
// ends, so that blocks with straight sides are not changed. The parameters g minimise
//
//   sum over pairs ( (d - d*) / w )^2  +  sum over arcs ( stiffness (w / L) g'' )^2   (integrals over u),
//
// L an arc's length: lines become normal to the arcs, while the spacing varies over no less than about the chord's
// width. Chords whose lines are already nearly normal keep equal fractions.

#include <vector>

#include "sizing/measured_layout.hpp"

namespace quadrille::refine {

struct AlignOptions {
  double tolerance = 0.25;    ///< a chord with |d - d*| / w <= tolerance everywhere keeps equal fractions
  double stiffness = 0.3;     ///< > 0
  double least_slope = 0.25;  ///< g' >= least_slope everywhere
};

/// One parameter for each arc. Linear in the number of arcs except for a sparse factorisation in each misaligned chord.
std::vector<sizing::ArcParameter> align_chords(const sizing::MeasuredLayout& measured,
                                               const AlignOptions& options = {});

}  // namespace quadrille::refine
