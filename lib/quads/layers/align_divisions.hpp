#pragma once
// Reduces the difference between the divisions of opposite arcs of a chord, so that lines are nearly normal to the arcs
// across narrow blocks while they change from one division to the other across wide ones.
//
// Above the layers the divisions u of all arcs (in the chord's parameter, scaled to 0 and 1 where the layers end) solve
//
//   (u_a - own_a) + sum over opposite arcs b with as many layers at both ends  w_ab (u_a - u_b) = 0,
//
//   w_ab = (mean length of a and b / (2 distance))^4,
//
// with twice the distance if there are layers, unless refine/align_chords found equal fractions to skew the chord. The
// matrix is an M-matrix with row sums 1: every u is a weighted mean of the arcs' own divisions, and rises as they do.

#include "layers/layered_chord.hpp"

namespace quadrille::layers {

/// `divisions`: by position in the chord, as from layered_divisions; layers are not moved.
void align_divisions(const LayeredChord& chord, std::vector<sizing::ArcDivision>& divisions);

}  // namespace quadrille::layers
