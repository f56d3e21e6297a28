#pragma once
// Admissible valences of a corner of the layout: its blocks need angles between 15 and 165 degrees (lib/method.md §5).

namespace quadrille::guide {

inline constexpr double least_block_angle = 15, greatest_block_angle = 165;  // degrees
inline constexpr int greatest_corner_valence = 4;

/// Whether a valence may be prescribed: it is 0 to 4, and angle / valence is between 15 and 165 degrees. Valence 0, a
/// degenerate corner, is admissible, and valence 1 also below 15 degrees: a sharp corner needs one block.
bool is_admissible_valence(double angle_degrees, int valence);

/// Whether a corner may have that valence because it absorbs nodes: angle / valence is between 15 and 165 degrees and
/// |valence - angle / 90 degrees| <= 0.75, so that blocks remain near right angles; valence 0 only within 0.02 radians
/// of the tie at 45 degrees.
bool is_admissible_after_absorption(double angle_degrees, int valence);

}  // namespace quadrille::guide
