#pragma once
// Bodies in far fields, for the tests of this folder.

#include "../triangulate/faces.hpp"

namespace quadrille::testing_faces {

/// Names all curves of the outline `farfield`.
inline CadFace in_far_field(CadFace face) {
  for (int c = 0; c < face.loop_offsets[1]; ++c) face.curve_names[c] = "farfield";
  return face;
}

/// A half circle to the left and a rectangle to the right of the tail at (1, 0), and boxes and circles around it.
inline Loop c_outline() {
  Loop loop = polygon({{1, -8}, {9, -8}, {9, 8}, {1, 8}});
  loop.back() = curve::circular_arc({1, 0}, 8, half_pi, 3 * half_pi);
  return loop;
}
inline Loop box() { return polygon({{-8, -8}, {8, -8}, {8, 8}, {-8, 8}}); }

/// Clockwise: a wedge with a sharp tail at (1, 0), 338 degrees there, and corners of 281 degrees in front.
inline Loop wedge() { return polygon({{1, 0}, {0, -0.2}, {0, 0.2}}); }

/// With a round front, where corners of 191 degrees have valence 2; the blunt tail has two corners of 259 degrees.
inline Loop sharp_body() {
  Loop loop = wedge();
  loop[1] = curve::circular_arc({0, 0}, 0.2, -half_pi, -3 * half_pi);
  return loop;
}
inline Loop blunt_body() {
  Loop loop = polygon({{1, 0.01}, {1, -0.01}, {0, -0.2}, {0, 0.2}});
  loop[2] = curve::circular_arc({0, 0}, 0.2, -half_pi, -3 * half_pi);
  return loop;
}

}  // namespace quadrille::testing_faces
