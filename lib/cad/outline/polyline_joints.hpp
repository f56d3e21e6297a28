#pragma once
// Small kinks of polylines that start no line.

#include "model/cad_face.hpp"

namespace quadrille::outline {

/// A greater kink, degrees, gives a corner another valence than 2 within the window of ties (lib/method.md §3).
inline constexpr double greatest_polyline_kink = 43;

/// Fewer kinks stay corners: lines from them can be followed to their ends, and elements are better with them.
inline constexpr int many_polyline_kinks = 200;

/// Corners inside polylines whose tangent jumps by at most `kink`, radians, become smooth joints if they are `many` or
/// more: no line of the layout starts there. A polyline is a chain of eight straight curves or more of one loop, each
/// shorter than a fiftieth of the diameter: it samples a curve or a coast, and lines from each of its corners would be
/// far nearer to each other than elements of any useful size. The field keeps its exact boundary data, and elements
/// still end at each joint. For a face of one region; another stays, because its lines must match across interfaces.
/// Returns the number of corners that became smooth.
int smooth_polylines(CadFace& face, double kink, int many = many_polyline_kinks);

}  // namespace quadrille::outline
