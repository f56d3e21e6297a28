#pragma once
// Lines that end on one of two sides near a line of the other side are bent to meet it.

#include <array>
#include <functional>
#include <vector>

#include "couple/region_layouts.hpp"
#include "couple/side_pairs.hpp"

namespace quadrille::couple {

inline constexpr double greatest_bend = 0.1;  ///< radians: of lines that become one
inline constexpr double relative_tie = 1e-6;  ///< lengths and bends of relative difference below it are equal

/// Two nodes of both sides that become one.
struct NodeMatch {
  std::array<int, 2> nodes{};  ///< SidePair::nodes
  double position = 0;         ///< along the first side; of no meaning if one of the nodes cannot move
};

/// Two nodes match if each is the nearest one to the other and their distance is less than a third of that to the next
/// node on either side, or no line is bent by more than `greatest_bend`: in the middle between them, or at the one that
/// cannot move (a corner, or an irregular node). Nodes nearer than 1e-9 diameters need no match.
std::vector<NodeMatch> matches_of_neighbours(const SidePair& pair, double diameter);

using MatchRule = std::function<std::vector<NodeMatch>(const SidePair&)>;

/// Moves the ends of lines of the layouts, and so the lines, to the places at which they match. `pairs`: of these
/// layouts. Raises the largest deviations of their certificates. Returns the number of matches.
int match_line_ends(RegionLayouts& layouts, const std::vector<SidePair>& pairs, const MatchRule& rule);

/// By the rule `matches_of_neighbours`.
int match_line_ends(RegionLayouts& layouts, const std::vector<SidePair>& pairs);

}  // namespace quadrille::couple
