#pragma once
// Refuses regions that are not one connected part of the plane.

#include "heal/heal_scale.hpp"
#include "sew/sew_regions.hpp"

namespace quadrille::sew {

/// Throws FormatError, with the faces, the place, the size and a remedy, unless the regions cover a connected part of
/// the plane once. Proof: the regions are glued along their interfaces; if the boundary of the result is one simple
/// loop around simple loops that lie beside each other, each point has the winding number 1 or 0 of this boundary,
/// which is the sum of those of the regions. Also refused are boundaries of two regions along each other, not further
/// apart than what is clearly a slip: a thousandth of the diameter, or ten times a tolerance that was given. `scale`:
/// of all regions together; `is_asked`: a tolerance was given.
void require_one_sheet(const Sewn& sewn, const heal::HealScale& scale, bool is_asked);

/// The remedy with which messages about several faces end.
inline constexpr const char* face_choice_text =
    "choose one planar face with --face NUMBER or --face NAME (cad2tri --list FILE shows numbers and names)";

}  // namespace quadrille::sew
