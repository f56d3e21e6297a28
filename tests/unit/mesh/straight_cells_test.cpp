#include "mesh/straight_cells.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace quadrille::mesh {
namespace {

/// Two unit cubes side by side along x, moved by the map. Faces: the common one, then those of the first cube and those
/// of the second.
StraightCells two_cubes(const std::function<Vec3(Vec3)>& map) {
  StraightCells cells;
  cells.num_cells = 2;
  for (int x = 0; x < 3; ++x)
    for (const double z : {0.0, 1.0})
      for (const double y : {0.0, 1.0}) cells.points.push_back(map({1.0 * x, y, z}));
  const auto p = [](int x, int y, int z) { return 4 * x + 2 * z + y; };
  cells.faces.push_back({{p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)}, 0, 1});
  for (const int k : {0, 1}) {
    const int end = 2 * k;  // the outer face across x
    std::array<int, 4> outer{p(end, 0, 0), p(end, 1, 0), p(end, 1, 1), p(end, 0, 1)};
    if (k == 0) std::swap(outer[1], outer[3]);
    cells.faces.push_back({outer, k});
    cells.faces.push_back({{p(k, 0, 0), p(k + 1, 0, 0), p(k + 1, 0, 1), p(k, 0, 1)}, k});
    cells.faces.push_back({{p(k, 1, 0), p(k, 1, 1), p(k + 1, 1, 1), p(k + 1, 1, 0)}, k});
    cells.faces.push_back({{p(k, 0, 0), p(k, 1, 0), p(k + 1, 1, 0), p(k + 1, 0, 0)}, k});
    cells.faces.push_back({{p(k, 0, 1), p(k + 1, 0, 1), p(k + 1, 1, 1), p(k, 1, 1)}, k});
  }
  return cells;
}

Vec3 same(Vec3 x) { return x; }
void expect_near(Vec3 x, Vec3 expected) { EXPECT_LT(distance(x, expected), 1e-14) << x.x << ' ' << x.y << ' ' << x.z; }

TEST(StraightCells, CubesHaveVolumeOneAndAreasThatPointOutOfTheOwner) {
  for (const CellCentre centre : {CellCentre::volume, CellCentre::surface}) {
    const CellGeometry of = cell_geometry(two_cubes(same), centre);
    for (const int k : {0, 1}) {
      EXPECT_NEAR(of.volumes[k], 1, 1e-15);
      expect_near(of.centres[k], {k + 0.5, 0.5, 0.5});
    }
    expect_near(of.face_areas[0], {1, 0, 0});
    expect_near(of.face_areas[1], {-1, 0, 0});
    expect_near(of.face_areas[6], {1, 0, 0});
    expect_near(of.face_centres[0], {1, 0.5, 0.5});
  }
}

TEST(StraightCells, AreasOfAClosedCellSumToZeroHoweverItIsWarped) {
  const StraightCells cells = two_cubes([](Vec3 x) { return x + Vec3{0.3 * x.y * x.z, 0.2 * x.x * x.z, 0}; });
  const CellGeometry of = cell_geometry(cells, CellCentre::volume);
  Vec3 sum;
  for (int f = 0; f < 6; ++f) sum += of.face_areas[f];
  expect_near(sum, {});
}

/// Of the triangles round the middle of a kite, the longer ones weigh more: x = 1/3 of the corners' sum.
TEST(StraightCells, TheCentreOfAFaceIsThatOfItsArea) {
  StraightCells cells;
  cells.num_cells = 1;
  cells.points = {{-1, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}};
  cells.faces = {{{0, 1, 2, 3}, 0}};
  const CellGeometry of = cell_geometry(cells, CellCentre::surface);
  expect_near(of.face_centres[0], {2.0 / 3, 0, 0});
  expect_near(of.face_areas[0], {0, 0, 4});
}

TEST(StraightCells, AFaceWithoutAreaHasTheMeanOfItsCornersAsItsCentre) {
  StraightCells cells;
  cells.num_cells = 1;
  cells.points = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  cells.faces = {{{0, 1, 2, 3}, 0}};
  expect_near(cell_geometry(cells, CellCentre::volume).face_centres[0], {2, 0, 0});
}

/// The first cube is turned inside out: there is no centroid of a volume that is not positive.
TEST(StraightCells, ACellWithoutPositiveVolumeHasTheMeanOfItsFacesAsItsCentre) {
  const CellGeometry of = cell_geometry(two_cubes([](Vec3 x) { return Vec3{-x.x, x.y, x.z}; }), CellCentre::volume);
  EXPECT_NEAR(of.volumes[0], -1, 1e-15);
  expect_near(of.centres[0], {-0.5, 0.5, 0.5});
  const CellGeometry flat = cell_geometry(two_cubes([](Vec3 x) { return Vec3{x.x, x.y, 0}; }), CellCentre::volume);
  EXPECT_EQ(flat.volumes[0], 0);
  expect_near(flat.centres[0], {0.5, 0.5, 0});
}

}  // namespace
}  // namespace quadrille::mesh
