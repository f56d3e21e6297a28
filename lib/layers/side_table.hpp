#pragma once
// A chain's points by polynomials, for the many looks that a column takes at the sides of its block: some twenty times
// as fast as the chain itself, whose arc length has to be inverted each time.

#include <vector>

#include "curve/chain.hpp"

namespace quadrille::layers {

class SideTable {
 public:
  SideTable() = default;
  /// Panels of degree 10, halved until they are within 1e-13 of the chain's length of it, or 1/4096 long.
  SideTable(const curve::Chain& chain, bool backwards);

  /// The point at the fraction f of the length, from the other end where `backwards`; exact at 0 and 1.
  Vec2 at(double f) const;

 private:
  void add(const curve::Chain& chain, bool backwards, double low, double high);

  std::vector<double> ends_;  ///< of the panels
  std::vector<Vec2> points_;  ///< at each panel's Gauss-Lobatto-Legendre points
};

}  // namespace quadrille::layers
