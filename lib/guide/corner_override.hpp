#pragma once
// A corner valence prescribed by the user.

#include <string>

namespace quadrille::guide {

/// Curves a and b that meet in a corner, in either order, and the prescribed valence. Where they meet in two corners
/// (a half disc), the one where a ends and b begins, the face on the left.
struct CornerOverride {
  int curve_a = 0, curve_b = 0;
  int valence = 2;
};

/// From "a:b=valence", as in --corner-valence 3:4=2; throws UsageError.
CornerOverride parse_corner_override(const std::string& text);

}  // namespace quadrille::guide
