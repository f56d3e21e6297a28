#include "mesh/cell_quality.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace quadrille::mesh {
namespace {

using Map = std::function<Vec3(Vec3)>;
constexpr double degree = std::numbers::pi / 180;

/// Cells between these planes x = const, y and z in [0, 1], moved by the map. Faces of cell k: that at its lower x (of
/// the first cell alone), that at its upper x, y = 0, y = 1, z = 0, z = 1.
StraightCells row_of_cells(const std::vector<double>& planes, const Map& map) {
  StraightCells cells;
  cells.num_cells = static_cast<int>(planes.size()) - 1;
  for (const double x : planes)
    for (const double z : {0.0, 1.0})
      for (const double y : {0.0, 1.0}) cells.points.push_back(map({x, y, z}));
  const auto point = [](int cell, int x, int y, int z) { return 4 * (cell + x) + 2 * z + y; };
  for (int k = 0; k < cells.num_cells; ++k) {
    const auto p = [&](int x, int y, int z) { return point(k, x, y, z); };
    if (k == 0) cells.faces.push_back({{p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0)}, k});
    cells.faces.push_back({{p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)}, k, k + 1 < cells.num_cells ? k + 1 : -1});
    cells.faces.push_back({{p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1)}, k});
    cells.faces.push_back({{p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0)}, k});
    cells.faces.push_back({{p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0)}, k});
    cells.faces.push_back({{p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)}, k});
  }
  return cells;
}

Vec3 same(Vec3 x) { return x; }
/// Leans by 30 degrees.
Vec3 leaning(Vec3 x) { return {x.x + std::tan(30 * degree) * x.y, x.y, x.z}; }
/// Cells beyond x = 1 rise.
Vec3 rising(Vec3 x) { return {x.x, x.y + std::max(0.0, x.x - 1), x.z}; }

using MeasureOf = std::vector<CellSample>(const StraightCells&, const CellGeometry&);
std::vector<CellSample> measured(MeasureOf& measure, const StraightCells& cells,
                                 CellCentre centre = CellCentre::volume) {
  return measure(cells, cell_geometry(cells, centre));
}
double greatest(const std::vector<CellSample>& samples) {
  return std::max_element(samples.begin(), samples.end(), [](auto& a, auto& b) { return a.value < b.value; })->value;
}
double least(const std::vector<CellSample>& samples) {
  return std::min_element(samples.begin(), samples.end(), [](auto& a, auto& b) { return a.value < b.value; })->value;
}

TEST(CellQuality, CentresVolumesAndAreasOfAFrustum) {
  // A truncated pyramid of height 1 along x with squares of side 2 and 1: V = 7/3, centroid at 11/28.
  const StraightCells cells = row_of_cells({0, 1}, [](Vec3 x) {
    const double width = 2 - x.x;
    return Vec3{x.x, width * (x.y - 0.5), width * (x.z - 0.5)};
  });
  const CellGeometry volume = cell_geometry(cells, CellCentre::volume);
  EXPECT_NEAR(volume.volumes[0], 7.0 / 3, 1e-14);
  EXPECT_NEAR(volume.centres[0].x, 11.0 / 28, 1e-14);
  EXPECT_NEAR(norm(volume.face_areas[0]), 4, 1e-14);
  EXPECT_LT(volume.face_areas[0].x, 0);
  // Areas 4 at x = 0, 1 at x = 1, and four trapezoids of area 1.5 h, h^2 = 1.25, whose centroids are at 4/9.
  const double sides = 6 * std::sqrt(1.25);
  const CellGeometry surface = cell_geometry(cells, CellCentre::surface);
  EXPECT_NEAR(surface.centres[0].x, (1 + sides * 4 / 9) / (5 + sides), 1e-14);
}

TEST(CellQuality, AnglesOfFacesBetweenCellsAndOnTheBoundary) {
  const std::vector<CellSample> inner = measured(face_angles, row_of_cells({0, 1, 3}, leaning));
  ASSERT_EQ(inner.size(), 1U);
  EXPECT_NEAR(inner[0].value, 30, 1e-10);
  EXPECT_EQ(inner[0].cell, 0);
  EXPECT_NEAR(inner[0].position.x, 1 + 0.5 * std::tan(30 * degree), 1e-14);
  const std::vector<CellSample> outer = measured(boundary_face_angles, row_of_cells({0, 1}, leaning));
  ASSERT_EQ(outer.size(), 6U);
  EXPECT_NEAR(greatest(outer), 30, 1e-10);
  EXPECT_NEAR(outer[4].value, 0, 1e-5);
}

TEST(CellQuality, SkewnessIsTheOffsetOverTheHalfWidthOfTheFace) {
  const StraightCells cells = row_of_cells({0, 1, 2}, rising);
  const std::vector<CellSample> samples = measured(face_skewness, cells);
  ASSERT_EQ(samples.size(), cells.faces.size());
  EXPECT_NEAR(samples[1].value, 0.5, 1e-14);  // 0.25 over 0.5
  EXPECT_NEAR(samples[0].value, 0, 1e-14);
  // The outer face of the leaning cell: its centre is 0.25 from the foot of the perpendicular.
  EXPECT_NEAR(samples[6].value, 1, 1e-14);
  EXPECT_NEAR(measured(face_offsets, cells)[0].value, 1 - std::cbrt(0.25), 1e-14);
}

TEST(CellQuality, AspectRatioOfABoxAndOfAPlate) {
  StraightCells cells = row_of_cells({0, 4}, same);
  EXPECT_NEAR(measured(cell_aspects, cells)[0].value, 4, 1e-14);
  for (Vec3& x : cells.points) x.z *= 0.01;
  EXPECT_NEAR(measured(cell_aspects, cells)[0].value, 400, 1e-10);
  cells.is_plate = true;
  EXPECT_NEAR(measured(cell_aspects, cells)[0].value, 4, 1e-14);
}

TEST(CellQuality, PyramidsOfAFoldedCellAreNotPositive) {
  EXPECT_NEAR(least(measured(face_pyramids, row_of_cells({0, 1}, same))), 1, 1e-14);
  // A dart of area 10, whose centroid (2, 2) lies behind both of its short sides.
  const StraightCells dart = row_of_cells({0, 1}, [](Vec3 x) {
    const double a = x.x, b = x.y;
    return Vec3{10 * a * (1 - b) + a * b, 10 * b * (1 - a) + a * b, x.z};
  });
  EXPECT_NEAR(cell_geometry(dart, CellCentre::volume).volumes[0], 10, 1e-13);
  const std::vector<CellSample> samples = measured(face_pyramids, dart);
  for (const int face : {1, 3}) EXPECT_LT(samples[face].value, 0) << face;
  StraightCells folded = row_of_cells({0, 1}, same);
  for (const int corner : {0, 1, 2, 3}) folded.points[corner].x = 1.5;  // behind the other face
  EXPECT_LE(least(measured(face_pyramids, folded)), 0);
}

TEST(CellQuality, RatiosOfVolumesAndConditionOfGradients) {
  EXPECT_NEAR(measured(volume_ratios, row_of_cells({0, 1, 4}, same))[0].value, 3, 1e-14);
  EXPECT_NEAR(measured(gradient_conditions, row_of_cells({0, 1}, same))[0].value, 1, 1e-14);
  EXPECT_NEAR(measured(gradient_conditions, row_of_cells({0, 1}, leaning))[0].value, 1.0 / 3, 1e-14);
}

TEST(CellQuality, FacesOfAPlaneDeviateFromTheirMeanNormal) {
  StraightCells cells = row_of_cells({0, 1, 2}, rising);
  EXPECT_TRUE(measured(plane_deviations, cells).empty());
  cells.planes = {{4, 9}, {2, 7}};  // z = 0; the lower sides, of which the second one turns by 45 degrees
  const std::vector<CellSample> samples = measured(plane_deviations, cells);
  ASSERT_EQ(samples.size(), 4U);
  EXPECT_NEAR(samples[0].value, 0, 1e-15);
  for (const int k : {2, 3}) EXPECT_NEAR(samples[k].value, std::sin(22.5 * degree), 1e-14);
  EXPECT_EQ(samples[3].cell, 1);
}

TEST(CellQuality, CoupledFacesHaveTheCellBehindTheMotion) {
  // A quarter ring of four cells that turn about z; a rotation by 90 degrees maps the first face onto the last.
  StraightCells cells = row_of_cells({0, 1, 2, 3, 4}, [](Vec3 x) {
    const double angle = 22.5 * degree * x.x, radius = 2 - x.y;
    return Vec3{radius * std::cos(angle), radius * std::sin(angle), x.z};
  });
  ASSERT_GT(cell_geometry(cells, CellCentre::volume).volumes[0], 0);
  EXPECT_NEAR(measured(face_skewness, cells)[0].value, 0, 0.02);
  cells.coupled = {{0, 16, {{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, {}}}};
  const std::vector<CellSample> angles = measured(face_angles, cells), skewness = measured(face_skewness, cells);
  ASSERT_EQ(angles.size(), 5U);
  for (const CellSample& sample : angles) EXPECT_NEAR(sample.value, 0, 1e-5);
  for (const int face : {0, 1, 16}) EXPECT_NEAR(skewness[face].value, skewness[1].value, 1e-12) << face;
  cells.coupled[0].motion.shift = {0, 0.5, 0};
  EXPECT_GT(greatest(measured(face_angles, cells)), 10);
}

}  // namespace
}  // namespace quadrille::mesh
