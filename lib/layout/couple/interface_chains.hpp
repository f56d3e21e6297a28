#pragma once
// Interfaces as chains of curves, with the ends of lines on both sides of each.

#include <array>
#include <vector>

#include "couple/region_layouts.hpp"
#include "curve/chain.hpp"

namespace quadrille::couple {

/// A node of one region's graph on an interface.
struct Station {
  int region = 0, node = -1;
  double position = 0;      ///< length along the chain
  bool is_movable = false;  ///< a regular line ends there, and nothing else is there
  double line_length = 0;   ///< of the last arc of that line
  bool is_cut = false;      ///< the line is a cut: its place is arbitrary
};

/// Successive curves of one loop whose partners succeed each other too, in opposite order.
struct InterfaceChain {
  std::vector<int> curves;      ///< of the whole, with the lower side's numbers
  std::vector<double> offsets;  ///< length up to the start of each curve, and the total
  bool is_closed = false;
  std::array<std::vector<Station>, 2> stations;  ///< of the lower and of the other side, by position

  double length() const { return offsets.back(); }
};

/// Cuts are lines at arbitrary places, which make sense only where no other line is.
enum class CutEnds { ignored, included };

/// What ends at a node of a layout; without its position. `kinds`: of the lines of its splines.
Station station_at(const graph::CandidateLayout& layout, const curve::CurveTable& table,
                   const std::vector<LineKind>& kinds, int region, int node);

/// Without the ends of chains that are not closed: a node there, a junction, is on both sides.
std::vector<InterfaceChain> interface_chains(const RegionLayouts& regions, CutEnds cuts);

/// The place on one side of the chain of the point at `place`, which is on it.
Place place_on_side(const CadFace& face, const InterfaceChain& chain, int side, const Place& place);

}  // namespace quadrille::couple
