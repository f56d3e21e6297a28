#pragma once
// Points of two opposite sides of a strip that lie opposite each other.

#include <optional>

#include "curve/chain.hpp"

namespace quadrille::block {

/// A chain in a chosen direction.
struct DirectedCurve {
  const curve::Chain* chain = nullptr;
  bool backwards = false;
  curve::ChainPoint at(double f) const {
    curve::ChainPoint p = chain->at(backwards ? 1 - f : f);
    if (backwards) p.tangent = -p.tangent;
    return p;
  }
};

/// The difference d of fractions, nearest to 0, at which a(middle - d / 2) and b(middle + d / 2) lie opposite each
/// other: the segment between them is at right angles to the sum of the tangents. std::nullopt if no d
/// has both fractions in [0.05, 0.95].
std::optional<double> opposite_point_offset(const DirectedCurve& a, const DirectedCurve& b, double middle);

}  // namespace quadrille::block
