#pragma once
// Faces of several regions made by hand.

#include <fmt/format.h>

#include <vector>

#include "../triangulate/faces.hpp"
#include "base/vec2.hpp"
#include "curve/nurbs.hpp"
#include "model/cad_face.hpp"

namespace quadrille::testing_faces {

inline bool are_reversed(const Nurbs& a, const Nurbs& b) {
  const Nurbs c = curve::reversed(b);
  if (a.poles.size() != c.poles.size()) return false;
  for (std::size_t i = 0; i < a.poles.size(); ++i)
    if (norm(a.poles[i] - c.poles[i]) > 1e-12) return false;
  return true;
}

/// One face of the given regions. Curves with the same poles in opposite directions are partners.
inline CadFace face_of_regions(const std::vector<CadFace>& regions) {
  CadFace whole;
  whole.loop_offsets = {0};
  whole.region_loops = {0};
  for (const CadFace& region : regions) {
    const int first = whole.num_curves();
    for (const Nurbs& curve : region.curves) whole.curves.push_back(curve);
    for (const Joint& joint : region.joints) whole.joints.push_back(joint);
    for (std::size_t l = 1; l < region.loop_offsets.size(); ++l)
      whole.loop_offsets.push_back(first + region.loop_offsets[l]);
    whole.region_names.push_back(fmt::format("region_{}", whole.region_names.size()));
    whole.region_loops.push_back(whole.num_loops());
  }
  for (int c = 0; c < whole.num_curves(); ++c) {
    whole.curve_names.push_back(fmt::format("curve_{}", c));
    whole.curve_cad_edges.push_back(c);
    whole.unnamed_curves.push_back(c);
  }
  whole.partners.assign(whole.num_curves(), -1);
  for (int a = 0; a < whole.num_curves(); ++a)
    for (int b = a + 1; b < whole.num_curves(); ++b) {
      if (!are_reversed(whole.curves[a], whole.curves[b])) continue;
      whole.curves[b] = curve::reversed(whole.curves[a]);
      whole.curve_names[b] = whole.curve_names[a];
      whole.partners[a] = b;
      whole.partners[b] = a;
    }
  std::vector<Vec2> points;
  for (const Nurbs& curve : whole.curves)
    for (int i = 0; i <= 32; ++i)
      points.push_back(curve::point(curve, curve.begin() + (curve.end() - curve.begin()) * i / 32));
  for (const Vec2 a : points)
    for (const Vec2 b : points) whole.diameter = std::max(whole.diameter, distance(a, b));
  return whole;
}

inline CadFace rectangle(Vec2 low, Vec2 high) {
  return make_face({polygon({low, {high.x, low.y}, high, {low.x, high.y}})});
}

/// A disc in the hole of a square.
inline CadFace disc_in_square() {
  return face_of_regions(
      {make_face({polygon({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}), hole({0, 0}, 1)}), make_face({circle({0, 0}, 1)})});
}

}  // namespace quadrille::testing_faces
