#pragma once
// The corners between a wall and its offset curve: whether blocks with layers pass them or close around the body.

#include <vector>

#include "base/enum_names.hpp"
#include "guide/corner_override.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::topology {

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
