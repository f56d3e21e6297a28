#pragma once
// Polygons as CAD faces, and the adapted field of a face: the chain's first three stages without files.

#include <algorithm>
#include <string>
#include <vector>

#include "adapt/adapt_loop.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "galerkin/solve_laplace.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille {

/// `corners` counter-clockwise.
inline CadFace polygon_face(const std::vector<Vec2>& corners) {
  const int n = static_cast<int>(corners.size());
  CadFace face;
  face.loop_offsets = {0, n};
  for (int i = 0; i < n; ++i) {
    const Vec2 before = corners[(i + n - 1) % n], here = corners[i], after = corners[(i + 1) % n];
    for (const Vec2 other : corners) face.diameter = std::max(face.diameter, distance(here, other));
    face.curves.push_back(curve::segment(here, after));
    face.curve_names.push_back("side" + std::to_string(i));
    face.curve_cad_edges.push_back(i);
    const double interior = wrap_two_pi(angle_of(before - here) - angle_of(after - here));
    face.joints.push_back({here, angle_of(here - before), angle_of(after - here), interior, true});
  }
  return face;
}

inline std::vector<Vec2> regular_polygon(int n, double turn) {
  std::vector<Vec2> corners;
  for (int i = 0; i < n; ++i) corners.push_back(unit(2 * pi * i / n + turn));
  return corners;
}

inline Field adapted_field(const CadFace& face) {
  Report report;
  const TriMesh mesh = triangulate::triangulate(face, {}, report);
  return adapt::adapt_loop(galerkin::solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 8), report), {}, report);
}

}  // namespace quadrille
