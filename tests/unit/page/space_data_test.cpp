#include "page/space_data.hpp"

#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "../export/two_hexes.hpp"
#include "sheet_samples.hpp"

namespace quadrille::page {
namespace {

QuadMesh on_the_sphere() {
  QuadMesh mesh = samples::quad_mesh();
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back(samples::on_sphere(x / 2));
  return mesh;
}

TEST(SpaceData, NeighboursShareTheCornersOfTheirOutlines) {
  const std::string data = space_data(on_the_sphere()).str();
  expect_contains(data, member("outlines", {0, 1, 2, 3, 1, 4, 5, 2}));
  expect_contains(data, member("elems", {0, -1, 1, -1}));
  expect_contains(data, "\"samples\":4,");
}

/// The box of the points 0 and 2 has its middle at 1.
TEST(SpaceData, PointsAreRelativeToTheMiddleOfTheirBox) {
  QuadMesh mesh = samples::quad_mesh();
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back({x.x + 10, 2 * x.y, 0});
  const std::string data = space_data(mesh).str();
  expect_contains(data, "\"middle\":[10.5,1,0]");
  expect_contains(data,
                  "\"points\":\"" + packed_floats({-0.5, -1, 0, 0, -1, 0, 0, 1, 0, -0.5, 1, 0, 0.5, -1, 0, 0.5, 1, 0}));
}

/// Eleven faces of two hexahedra; the common one bounds both.
TEST(SpaceData, FacesBetweenHexahedraAreThereOnce) {
  const std::string data = space_data(samples::hex_mesh()).str();
  const std::size_t begin = data.find("\"elems\":\"") + 9;
  EXPECT_EQ(data.find('"', begin) - begin, (11u * 8 + 2) / 3 * 4);
}

/// From order 2 on sides have points between their corners, which both faces have, one of them backwards.
TEST(SpaceData, CurvedSidesHaveFourPartsThatFacesShare) {
  const std::string data = space_data(exports::two_hexes({.order = 2, .map = exports::bent})).str();
  expect_contains(data, "\"samples\":16,");
  const std::size_t begin = data.find("\"points\":\"") + 10;
  const std::size_t num_points = 12 + 20 * 3;  // corners, and three on each edge
  EXPECT_EQ(data.find('"', begin) - begin, (num_points * 12 + 2) / 3 * 4);
}

}  // namespace
}  // namespace quadrille::page
