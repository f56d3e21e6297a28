#include "chart/plane_chart.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "surface/nurbs_surface.hpp"
#include "surface_samples.hpp"

namespace quadrille::chart {
namespace {

const double corner_angle = radians(1);

/// A radian of a ring between the radii 1 and 2 in the plane z = 3.
SpaceFace ring_sector() {
  return tests::face_of(tests::revolved(tests::line({1, 0, 3}, {2, 0, 3}), 0, 1), {{0, 1, 2, 3}}, 12, 5);
}

TEST(PlaneChart, CurvesAreTheExactOnes) {
  const SpaceFace face = ring_sector();
  const std::optional<PlaneChart> chart = plane_chart(face, corner_angle);
  ASSERT_TRUE(chart);
  ASSERT_EQ(chart->face.num_curves(), 4);
  EXPECT_FALSE(chart->face.chart);
  for (int c = 0; c < 4; ++c) {
    EXPECT_EQ(chart->face.curves[c].degree, face.curves[c].degree);
    EXPECT_EQ(chart->face.curves[c].knots, face.curves[c].knots);
    EXPECT_EQ(chart->face.curves[c].weights, face.curves[c].weights);
    EXPECT_NEAR(chart->face.joints[c].interior_angle, half_pi, 1e-12);
    EXPECT_TRUE(chart->face.joints[c].is_corner);
    for (int other = 0; other < 4; ++other)  // a motion keeps distances
      EXPECT_NEAR(distance(chart->face.curves[c].poles[0], chart->face.curves[other].poles[0]),
                  distance(face.curves[c].poles[0], face.curves[other].poles[0]), 1e-14);
  }
}

TEST(PlaneChart, TheMeshIsInThePlaneWithItsParameters) {
  const SpaceFace face = ring_sector();
  const SurfaceMesh mesh = plane_chart(face, corner_angle)->mesh;
  ASSERT_EQ(mesh.nodes.size(), mesh.image.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    EXPECT_NEAR(mesh.nodes[i].z, 3, 1e-14);
    EXPECT_EQ(mesh.scale[i], 0);
    EXPECT_NEAR(distance(mesh.image[i], mesh.image[0]), distance(mesh.nodes[i], mesh.nodes[0]), 1e-13);
    EXPECT_LT(distance(surface::point(face.surface, mesh.uv[i]), mesh.nodes[i]), 1e-12);
  }
}

/// Loops are counter-clockwise seen against the normal, on whichever side that is.
TEST(PlaneChart, TheFaceIsSeenFromItsNormal) {
  for (const Vec3& end : {Vec3{2, 0, 3}, Vec3{0.5, 0, 3}}) {
    const SpaceFace face = tests::face_of(tests::revolved(tests::line({1, 0, 3}, end), 0, 1), {{0, 1, 2, 3}}, 12, 5);
    const CadFace flat = plane_chart(face, corner_angle)->face;
    double area = 0;
    for (int c = 0; c < 4; ++c) area += cross(flat.curves[c].poles.front(), flat.curves[c].poles.back());
    EXPECT_GT(area, 0);
  }
}

TEST(PlaneChart, CurvedFacesHaveNone) {
  EXPECT_FALSE(plane_chart(cylinder_patch(), corner_angle));
  SpaceFace bent = ring_sector();
  bent.curves[0].poles[1].z += 1e-8;
  EXPECT_FALSE(plane_chart(bent, corner_angle)) << "a curve leaves the plane";
  bent.curves[0].poles[1].z = 3 + 1e-11;
  EXPECT_TRUE(plane_chart(bent, corner_angle)) << "rounding of a file";
}

}  // namespace
}  // namespace quadrille::chart
