#pragma once
// Lines that end on an interface near a line of the other side are bent to meet it.

#include <array>
#include <optional>
#include <vector>

#include "couple/interface_chains.hpp"
#include "couple/region_layouts.hpp"
#include "simplify/line_end_move.hpp"

namespace quadrille::couple {

/// Two ends on both sides of an interface meet if each is the nearest one to the other and their distance is less than
/// a third of that to the next end on either side, or no line is bent by more than 0.1 radian: in the middle between
/// them, or at the one that cannot move (a corner, or an irregular point). Returns the number of pairs that meet.
int meet_stations(RegionLayouts& regions, CutEnds cuts);

/// Two ends on both sides of a chain that meet.
struct Meeting {
  std::array<int, 2> stations{};  ///< of both sides
  double position = 0;            ///< along the chain; of no meaning if one of them is fixed
};

/// By the rule above; `same`: a length, ends nearer than that need not move.
std::vector<Meeting> meetings_on(const InterfaceChain& chain, double same);

/// The place at a position of the chain.
Place place_on(const CadFace& face, const InterfaceChain& chain, double position);

/// The move of the line that ends at a node to a place, on a boundary arc beside the node.
std::optional<simplify::LineEndMove> move_to(const graph::CandidateLayout& layout, int node, const Place& place);

}  // namespace quadrille::couple
