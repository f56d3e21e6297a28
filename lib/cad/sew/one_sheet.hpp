#pragma once
// Refuses regions that are not one connected part of the plane; what they have for a boundary together, and how two of
// them lie to each other, from samples of their boundaries, for messages.

#include <optional>
#include <vector>

#include "heal/heal_rules.hpp"
#include "sew/region.hpp"
#include "sew/sew_regions.hpp"

namespace quadrille::sew {

struct MeasuredPlace {
  Vec2 position;
  double size = 0;  ///< a length
};

/// Where the regions overlap, with the greatest distance of a sample in both regions from their boundaries; samples
/// that are nearer than `negligible` to a boundary do not count. std::nullopt if no sample is in both.
std::optional<MeasuredPlace> overlap(const Region& a, const Region& b, double negligible);

/// The least distance of their boundaries, to about a millionth of it, in the middle between them.
MeasuredPlace gap_between(const Region& a, const Region& b);

// Boundaries of two regions that run along each other with a gap that nobody can mean.

struct Slip {
  int a = 0, b = 0;  ///< the regions
  MeasuredPlace gap;
};

/// The greatest gap that is clearly a slip, a length: a thousandth of the diameter or, if a tolerance was given
/// (`is_asked`), ten times that.
double most_slip_of(const heal::HealScale& scale, bool is_asked);

/// The first curve of the boundary of the whole of which a third or more runs within `most_slip` of the boundary of
/// another region, and no further away than a fiftieth of its length; with the greatest distance there.
std::optional<Slip> find_slip(const Sewn& sewn, double most_slip);

/// Closed chains of the curves without partner, each with the whole on its left. After a curve comes the one that
/// bounds the same sector of the whole: the next one in its loop, across interfaces the next one after the partner, and
/// so on.
std::vector<std::vector<CurveId>> whole_boundary(const Sewn& sewn);

/// The regions that are connected by interfaces, by their least number.
std::vector<std::vector<int>> connected_regions(const Sewn& sewn);

/// Throws FormatError, with the faces, the place, the size and a remedy, unless the regions cover a connected part of
/// the plane once. Proof: the regions are glued along their interfaces; if the boundary of the result is one simple
/// loop around simple loops that lie beside each other, each point has the winding number 1 or 0 of this boundary,
/// which is the sum of those of the regions. Also refused are boundaries of two regions along each other, not further
/// apart than what is clearly a slip: a thousandth of the diameter, or ten times a tolerance that was given. `scale`:
/// of all regions together; `is_asked`: a tolerance was given.
void require_one_sheet(const Sewn& sewn, const heal::HealScale& scale, bool is_asked);

/// The remedy with which messages about several faces end.
inline constexpr const char* face_choice_text =
    "choose one face with --face NUMBER or --face NAME (cad2tri --list FILE shows numbers and names)";

}  // namespace quadrille::sew
