#pragma once
// Which corners count as tips (healing cuts them off, the triangulation says so where it cannot mesh them).

#include "base/angle.hpp"

namespace quadrille {

/// Radians: --blunt cuts the tips of corners below this angle off. Edges that meet at it take a number of elements
/// beside each other that grows like 1 / angle.
inline constexpr double blunted_angle = radians(0.2);

}  // namespace quadrille
