#pragma once
// Rows of elements around small holes in coarse meshes.
//
// A solution changes over the radius of a hole, however long elements shall be. Shorter elements along the hole would
// be carried across the face by the chords; thinner rows around it are not: their chord is closed. So the edges that
// point away from a small hole have at most the lengths
//
//   T, g T, g^2 T, ...     T = 0.9 L / 2 pi,  g = 1.5,  L the length of the hole,
//
// as far as that is below the prescribed length, and there is one row more than without a ring.

#include <vector>

#include "base/report.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/measured_layout.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

struct HoleRing {
  int loop = 0;           ///< of the face: the hole
  int chord = 0;          ///< closed: that of the blocks around the hole
  double thickness = 0;   ///< T, a length
  bool has_room = false;  ///< the other loops are at least L / pi away
};

/// Of the holes that are shorter than 12/20 diameters, with T below the prescribed length and around which there are
/// blocks with a side on the hole alone; ascending by loop. None in faces of several regions, with slits or periodic
/// sides. O(n log n) for n curves.
std::vector<HoleRing> hole_rings(const MeasuredLayout& measured, const SizeField& sizes);

/// One more element across each ring whose count is not prescribed.
void add_ring_rows(const std::vector<HoleRing>& rings, std::vector<ChordPlan>& plans);

/// The keys rings.* of the report, if there are any.
void report_rings(const std::vector<HoleRing>& rings, Report& report);

/// By element: the greatest length of its edges along s and t, infinite where no ring limits it. Empty: there are no
/// rings.
std::vector<Vec2> ring_lengths(const QuadMesh& mesh, const std::vector<HoleRing>& rings);

}  // namespace quadrille::sizing
