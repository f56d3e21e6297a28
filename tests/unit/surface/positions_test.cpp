#include "surface/positions.hpp"

#include <gtest/gtest.h>

#include "../chart_samples.hpp"

namespace quadrille::surface {
namespace {

TEST(PositionsOnFaces, OfAPlaneAreThoseOfItsFile) {
  CadFace face;
  face.origin = {10, 20};
  EXPECT_EQ(position_in_file(face, {1, 2}), (std::vector<double>{11, 22}));
  EXPECT_EQ(position_text(face, {0.5, -20}), "(10.5, 0)");
  EXPECT_EQ(rounded_position_text(face, {0.5, -20 + 1e-14}), "(10.5, 0)");
}

TEST(PositionsOnFaces, OfACurvedFaceAreOnItsSurface) {
  const CadFace face = samples::sphere_face(4, 3);
  for (const Vec2 x : {Vec2{0.1, 0.2}, Vec2{0.4, 0.05}, Vec2{0.25, 0.25}}) {
    EXPECT_LT(distance(position_in_space(face, x), samples::on_sphere(x)), 1e-3);
    EXPECT_EQ(position_in_file(face, x).size(), 3u);
  }
  EXPECT_EQ(position_text(face, {0, 0}), "(0, 0, 1)");
}

TEST(PositionsOnFaces, OutsideOfTheTrianglesIsTheNearestNode) {
  const CadFace face = samples::sphere_face(4, 3);
  EXPECT_LT(distance(position_in_space(face, {-5, -5}), {0, 0, 1}), 1e-12);
}

TEST(PositionsOnFaces, OfADamagedChartAreThoseOfTheChart) {
  CadFace face = samples::sphere_face(2, 3);
  Chart chart = *face.chart;
  chart.space_nodes.pop_back();
  face.chart = std::make_shared<const Chart>(chart);
  EXPECT_EQ(position_in_file(face, {0, 0}).size(), 2u);
}

}  // namespace
}  // namespace quadrille::surface
