#pragma once
// The angle between two curves that meet at a tip of the surface, as that of a cone: a pole where it has no normal.

#include <optional>

#include "model/space_face.hpp"

namespace quadrille::chart {

/// The angle, radians, of the surface between a curve and the one before it, which meet at the parameters `uv`: the
/// length of the directions X_v / |X_v| on the unit sphere, over the values of u at the pole. Of the two ways around a
/// closed surface the one with an angle nearer to `rough`. Nothing where the surface has a normal.
std::optional<double> tip_angle(const SpaceFace& face, int curve, Vec2 uv, double rough);

}  // namespace quadrille::chart
