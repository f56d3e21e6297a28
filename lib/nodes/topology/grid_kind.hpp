#pragma once
// The kind of grid around a body: C, O or H. It states the valence of each corner of a face with holes.
//
//   C-grid   blocks wrap around the front of the body and leave with its wake: outline corners at the outflow and
//            corners of holes keep the valence that they have in any face, other outline corners have two blocks. At
//            the outflow are both corners if there are two, else those downstream of the centre of all.
//   O-grid   blocks close around the body: outline corners have two blocks; reflex corners of holes have the least
//            valence that keeps blocks below 165 degrees: a blunt trailing edge has two corners of valence 2, a sharp
//            one has valence 3, so that a node of valence 3 is left in its wake.
//   H-grid   blocks pass the body: all corners keep the valence that they have in any face.
//
// The index sum of a half circle with a rectangle (two outline corners) around an aerofoil (sharp: one corner of
// valence 4; blunt: two of valence 3) is then 0 without a node.
//
// The corners between a wall and its offset curve: whether blocks with layers pass them or close around the body.

#include <vector>

#include "base/enum_names.hpp"
#include "base/vec2.hpp"
#include "guide/override_corners.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::topology {

/// `by_outline`: that of the far field; `none`: corner valences as in any face.
enum class GridKind { by_outline, c, o, h, none };
constexpr auto enum_names(GridKind) { return std::to_array({"auto", "c", "o", "h", "none"}); }

/// The grid that the outline of a face (of one region) with holes means, if all its curves are called `farfield`: O
/// without corners around one body, C with two corners, H with four, otherwise none. Where a slit (a wake) joins the
/// body to the outline, both are one loop, of which only the curves of this name count.
GridKind kind_of_outline(const CadFace& face);

/// The holes that are bodies: not those that other regions fill, nor slits.
int num_bodies(const CadFace& face);

/// C, O and H without that of a far field: what to try where its nodes give no layout. Empty without a far field.
std::vector<GridKind> other_grids(const CadFace& face);

/// Throws UsageError if a kind is chosen and the face has no hole.
void require_holes(const CadFace& face, GridKind kind);

/// The direction in which the wake leaves the bodies, a unit vector: the mean of the directions in which the reflex
/// corners of holes point, weighted by the squares of their angles beyond 180 degrees, so that a sharp tail counts more
/// than other corners, and both corners of a blunt tail about the same. (1, 0) if there is no reflex corner, or if
/// their directions cancel: the mean is shorter than 0.1.
Vec2 downstream(const CadFace& face);

/// The corners whose valences the grid changes. Corners that a user prescribed (source `corner`) are not among them.
std::vector<guide::CornerOverride> grid_corners(const CadFace& face, GridKind kind, const CriticalPoints& points);

/// `pass`: both families of lines go on beyond a corner of the body, V = 3 there and 1 on the offset curve: right
/// angles, and strips as thin as the layers from there to the far field. `close`: one line leads from the corner to
/// that of the offset curve, V = 2 at both, and no strip leaves. `by_bodies`: `close` where strips of one body would
/// run into another one.
enum class LayerCorners { by_bodies, pass, close };
constexpr auto enum_names(LayerCorners) { return std::to_array({"auto", "pass", "close"}); }

/// `by_bodies` decided for the whole face: `close` with more than one hole that is a body.
LayerCorners layer_corners(const CadFace& whole, LayerCorners corners);

/// The corners of V = 3 of a wall that is a loop, and those of V = 1 of the offset curve opposite to each, with V = 2.
/// Only where the sides of the wall beside the corner are longer than the distance between both corners: around shorter
/// ones, as a blunt trailing edge, lines would run apart. Prescribed valences stay. `face`: one region.
std::vector<guide::CornerOverride> closed_layer_corners(const CadFace& face, const CriticalPoints& points);

}  // namespace quadrille::topology
