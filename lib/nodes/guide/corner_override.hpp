#pragma once
// A corner valence prescribed by the user.

#include <string>

namespace quadrille::guide {

/// Curves a and b that meet at a corner, in either order, and the prescribed valence. If they meet at two corners (a
/// half disc), the corner at which a ends and b begins, with the face on the left.
struct CornerOverride {
  int curve_a = 0, curve_b = 0;
  int valence = 2;
};

/// Parses "a:b=valence", as in --corner-valence 3:4=2; throws UsageError.
CornerOverride parse_corner_override(const std::string& text);

}  // namespace quadrille::guide
