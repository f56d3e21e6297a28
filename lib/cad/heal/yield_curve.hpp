#pragma once
// Moves the ends of a curve to given points.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::heal {

/// The curve from `start` to `end`, in one piece or more. A line stays a line. An arc is first made longer or shorter
/// on its circle; then any curve is mapped by the one similarity that takes its ends to the new ones: an arc stays an
/// arc, and no tangent turns by more than the distance moved over the chord. A curve whose chord is short against its
/// reach (an arc above 300 degrees, a closed curve) is cut in its middle, which does not move. End poles are exactly
/// `start` and `end`.
std::vector<Nurbs> moved_curve(const Nurbs& curve, Vec2 start, Vec2 end);

}  // namespace quadrille::heal
