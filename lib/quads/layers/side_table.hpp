#pragma once
// The points of a block's side as piecewise polynomials of the arc-length fraction. Placing the nodes of a layered
// block evaluates its sides very often; the table is about twenty times as fast as the chain, which inverts its arc
// length for each point.

#include <vector>

#include "curve/chain.hpp"

namespace quadrille::layers {

class SideTable {
 public:
  SideTable() = default;
  /// Panels of degree 10, halved until they are within 1e-13 of the chain's length of it, or 1/4096 long.
  SideTable(const curve::Chain& chain, bool backwards);

  /// The point at the fraction f of the length, from the other end if `backwards`; exact at 0 and 1.
  Vec2 at(double f) const;

 private:
  void add(const curve::Chain& chain, bool backwards, double low, double high);

  std::vector<double> ends_;  ///< of the panels
  std::vector<Vec2> points_;  ///< at each panel's Gauss-Lobatto-Legendre points
};

}  // namespace quadrille::layers
