#include "stiffness/condensed_element.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../test_meshes.hpp"
#include "base/angle.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::stiffness {
namespace {

using Triangle = std::array<Vec2, 3>;

const Triangle triangle{Vec2{0.2, 0.1}, Vec2{1.5, 0.4}, Vec2{0.4, 1.3}};

// Turned by an angle, scaled and moved.
Vec2 moved(Vec2 x, double angle, double scale) {
  const Vec2 direction = scale * unit(angle);
  return Vec2{3, -2} + Vec2{direction.x * x.x - direction.y * x.y, direction.y * x.x + direction.x * x.y};
}

Triangle moved(const Triangle& t, double angle, double scale) {
  return {moved(t[0], angle, scale), moved(t[1], angle, scale), moved(t[2], angle, scale)};
}

TEST(ElementShapes, SimilarTrianglesHaveTheSame) {
  const std::vector<spectral::TriMap> maps{spectral::TriMap(triangle), spectral::TriMap(moved(triangle, 2, 1e-2)),
                                           spectral::TriMap(moved(triangle, -1, 40)),
                                           spectral::TriMap({triangle[1], triangle[2], triangle[0]})};
  EXPECT_EQ(first_of_shape(maps), std::vector<int>({0, 0, 0, 3}));
}

TEST(ElementShapes, SlightlyDifferentTrianglesAreDifferent) {
  Triangle other = triangle, mirrored = triangle;
  other[2].y += 1e-9;
  for (Vec2& x : mirrored) x.y = -x.y;
  EXPECT_EQ(first_of_shape({spectral::TriMap(triangle), spectral::TriMap(other),
                            spectral::TriMap({mirrored[0], mirrored[2], mirrored[1]})}),
            std::vector<int>({0, 1, 2}));
}

TEST(ElementShapes, CurvedElementsAreComparedWithAllTheirNodes) {
  std::vector<Vec2> nodes;
  for (const Vec2 xi : spectral::tri_nodes(3)) nodes.push_back(spectral::TriMap(triangle).position(xi));
  nodes[4] = nodes[4] + Vec2{0.02, -0.03};
  std::vector<Vec2> similar, other = nodes;
  for (const Vec2 x : nodes) similar.push_back(moved(x, 0.7, 0.1));
  other[5] = other[5] + Vec2{1e-6, 0};
  EXPECT_EQ(first_of_shape({spectral::TriMap(triangle), spectral::TriMap(3, nodes.data()),
                            spectral::TriMap(3, similar.data()), spectral::TriMap(3, other.data())}),
            std::vector<int>({0, 1, 1, 3}));
}

TEST(ElementShapes, AMeshOfDividedParallelogramsHasTwo) {
  // Halves of a cell are similar; cells are divided along one diagonal and the other in turn.
  const std::vector<int> first = first_of_shape(mesh::tri_maps(parallelogram_mesh({0, 0}, {2, 0}, {0.5, 1.5}, 8)));
  EXPECT_EQ(std::set<int>(first.begin(), first.end()), std::set<int>({0, 2}));
}

}  // namespace
}  // namespace quadrille::stiffness
