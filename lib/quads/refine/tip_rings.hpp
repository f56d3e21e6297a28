#pragma once
// Rings of elements around a tip of a surface (refine/surface_tips).
//
// The distance of an element at a tip from the surface is proportional to its length, whatever its order. So the
// m x m elements of each block at the tip are replaced by a copy of 2^-n their size and, between that and the rest, by
// n rings, each half as large as the one around it. Only the copy has elements at the tip; no element elsewhere
// becomes smaller. Sides of rings run along rays from the tip, along which a cone is straight, so that the distance of
// their elements depends on their angle, and falls with m.
//
// At the corner of the m x m elements opposite the tip, lines of two blocks of rings meet: a vertex of valence 5 there,
// and one of valence 3 in the copy.

#include <optional>

#include "model/quad_mesh.hpp"

namespace quadrille::refine {

struct TipRings {
  int width = 1;      ///< m, at least 1
  int num_rings = 1;  ///< n, at least 1
};

/// The mesh of a chart with rings around its vertex `tip` (a node). Vertices around the rings move along their
/// rays towards a circle, as far as angles become better. Prescribed lengths of new elements are 0; nodes in space and
/// measures are to be made again. None if there are not m x m elements, each way one more, in each block at the tip, or
/// interfaces run through them. O(n log n) for n elements.
std::optional<QuadMesh> with_tip_rings(const QuadMesh& mesh, int tip, TipRings rings);

}  // namespace quadrille::refine
