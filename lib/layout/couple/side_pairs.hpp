#pragma once
// Pairs of sides that are one side for the layout: the two sides of an interface or a slit, and periodic sides. Lines
// that end on one of them near a line of the other side are bent to meet it.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "couple/region_layouts.hpp"

namespace quadrille::couple {

/// A node of a layout on a side.
struct SideNode {
  int layout = 0, node = -1;  ///< RegionLayouts::layouts, and its graph's node
  double position = 0;        ///< arc length along the first side
  bool is_movable = false;    ///< a regular line ends there, and nothing else is there
  double line_length = 0;     ///< of the last arc of that line
  bool is_cut = false;        ///< the line is a cut: its place is arbitrary
};

/// Two sides, each a chain of curves of one loop; the second runs in the opposite direction. Of an interface, the
/// curves of the first side have the lower numbers.
struct SidePair {
  std::array<std::vector<int>, 2> curves;  ///< of the whole: curves[1][k] lies opposite to curves[0][k]
  std::vector<double> offsets;  ///< arc length up to the start of each curve of the first side, and the total
  bool is_closed = false;
  std::array<std::vector<SideNode>, 2> nodes;  ///< by position, without those at the ends of sides that are not closed

  double length() const { return offsets.back(); }
  /// Between two positions, the shorter way round.
  double distance(double a, double b) const {
    const double d = std::abs(a - b);
    return is_closed ? std::min(d, length() - d) : d;
  }
};

/// Cuts are lines at arbitrary places, which make sense only where no other line is.
enum class CutEnds { ignored, included };

/// With the nodes of the layouts of the regions: those that are not closed first.
std::vector<SidePair> interface_sides(const RegionLayouts& regions, CutEnds cuts);

/// With the nodes of the layout of the whole, or of the regions.
std::vector<SidePair> periodic_sides(const RegionLayouts& layouts);

/// The point on one side (0 or 1) of a point that is on either.
BoundaryPoint point_on_side(const CadFace& face, const SidePair& pair, int side, const BoundaryPoint& point);

/// The point on the first side at an arc length along it.
BoundaryPoint point_at(const CadFace& face, const SidePair& pair, double position);

inline constexpr double greatest_bend = 0.1;  ///< radians: of lines that become one
/// The same where a strip of blocks would wind onto itself else.
inline constexpr double greatest_forced_bend = 1;

/// Two nodes of both sides that become one.
struct NodeMatch {
  std::array<int, 2> nodes{};  ///< SidePair::nodes
  double position = 0;         ///< along the first side; of no meaning if one of the nodes cannot move
};

/// Two nodes match if each is the nearest one to the other and their distance is less than a third of that to the next
/// node on either side, or no line is bent by more than `most_bend`: in the middle between them, or at the one that
/// cannot move (a corner, or an irregular node). Nodes nearer than 1e-9 diameters need no match.
std::vector<NodeMatch> matches_of_neighbours(const SidePair& pair, double diameter, double most_bend = greatest_bend);

using MatchRule = std::function<std::vector<NodeMatch>(const SidePair&)>;

/// Moves the ends of lines of the layouts, and so the lines, to the places at which they match. `pairs`: of these
/// layouts. Raises the largest deviations of their certificates. Returns the number of matches.
int match_line_ends(RegionLayouts& layouts, const std::vector<SidePair>& pairs, const MatchRule& rule);

/// By the rule `matches_of_neighbours`.
int match_line_ends(RegionLayouts& layouts, const std::vector<SidePair>& pairs, double most_bend = greatest_bend);

}  // namespace quadrille::couple
