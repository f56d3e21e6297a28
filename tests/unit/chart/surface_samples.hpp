#pragma once
// Triangles of faces with closed forms, before they have a chart.

#include <cmath>
#include <numbers>
#include <vector>

#include "chart/intrinsic_triangles.hpp"
#include "chart/rough_chart.hpp"
#include "chart/surface_mesh.hpp"
#include "space_faces.hpp"

namespace quadrille::chart {

/// Two radians of a cylinder of radius 2, 3 high: 4 x 3 when it is unrolled.
inline SpaceFace cylinder_patch() {
  return tests::face_of(tests::revolved(tests::line({2, 0, 0}, {2, 0, 3}), 0, 2), {{0, 1, 2, 3}}, 8, 4);
}
/// A whole cylinder of radius 1, 1 high: loop 0 below, loop 1 above.
inline SpaceFace tube() {
  return tests::face_of(tests::revolved(tests::line({1, 0, 0}, {1, 0, 1})), {{0}, {2}}, 12, 2);
}
/// The cap of the unit sphere whose rim has radius 0.8.
inline SpaceFace cap() {
  return tests::face_of(tests::revolved(tests::profile_arc(0, 1, std::acos(0.8), std::numbers::pi / 2)), {{0}}, 12, 4);
}

/// The fine triangles of a face, with an approximate image, and the same triangles of an order.
struct SurfaceSample {
  explicit SurfaceSample(SpaceFace of) : face(std::move(of)) {
    lengths.reserve(face.curves.size());
    for (const SpaceCurve& curve : face.curves) lengths.emplace_back(curve);
    fine = delaunay_triangles(face, lengths);
    rough = rough_chart(face.face, fine);
  }
  SurfaceSample(const SurfaceSample&) = delete;
  SurfaceSample& operator=(const SurfaceSample&) = delete;

  SurfaceMesh lifted(int order) const { return lifted_mesh(face, lengths, rough, rough.plane, order); }

  SpaceFace face;
  std::vector<SpaceLength> lengths;
  IntrinsicTriangles fine;
  SurfaceMesh rough;
};

}  // namespace quadrille::chart
