#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

/// The part of the text between two words.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from) + from.size();
  return text.substr(begin, text.find(to, begin) - begin);
}

TEST(BlockMeshHex, LayersAreGradedSections) {
  const auto graded = [](Vec3 x) { return Vec3{x.x, x.y, x.z < 1 ? x.z : 1 + 3 * (x.z - 1)}; };
  const std::string text = block_mesh_dict(two_hexes({.layers = 2, .map = graded})).bytes;
  EXPECT_NE(text.find("scale 0.001;"), std::string::npos);
  EXPECT_EQ(between(text, "blocks\n(\n", ");\n\n"), R"(    hex (0 1 2 3 6 7 8 9) fluid (1 1 2) edgeGrading
    (
        1
        1
        1
        1
        1
        1
        1
        1
        ((0.25 1 1)(0.75 1 1))
        ((0.25 1 1)(0.75 1 1))
        ((0.25 1 1)(0.75 1 1))
        ((0.25 1 1)(0.75 1 1))
    )
    hex (1 4 5 2 7 10 11 8) solid (1 1 2) edgeGrading
    (
        1
        1
        1
        1
        1
        1
        1
        1
        ((0.25 1 1)(0.75 1 1))
        ((0.25 1 1)(0.75 1 1))
        ((0.25 1 1)(0.75 1 1))
        ((0.25 1 1)(0.75 1 1))
    )
)");
  EXPECT_EQ(between(text, "    bottom\n", "    }\n"), R"(    {
        type patch;
        faces
        (
            (0 3 2 1)
            (1 2 5 4)
        );
)");
  EXPECT_EQ(between(text, "    outlet\n", "    }\n"), R"(    {
        type patch;
        faces
        (
            (4 5 11 10)
        );
)");
  EXPECT_NE(text.find("    (4 0 4)\n"), std::string::npos);
  EXPECT_EQ(text.find("frontAndBack"), std::string::npos);
}

/// Neither the plane nor the way must be along an axis.
TEST(BlockMeshHex, ObliqueSweepsOfTiltedFaces) {
  const auto tilted = [](Vec3 x) {
    const double c = std::cos(0.4), s = std::sin(0.4);
    const Vec3 sheared{x.x + 0.5 * x.z, x.y - 0.25 * x.z, x.z};
    return Vec3{sheared.x, c * sheared.y - s * sheared.z, s * sheared.y + c * sheared.z};
  };
  const HexMesh mesh = two_hexes({.order = 3, .layers = 2, .map = tilted});
  const Exported exported = block_mesh_dict(mesh);
  const std::string text = exported.bytes;
  EXPECT_NE(text.find("(1 1 2) simpleGrading (1 1 1)"), std::string::npos);
  EXPECT_TRUE(exported.losses.size() == 1 && exported.losses[0].find("interface") != std::string::npos);
  // Twelve vertices, each a corner of the mesh.
  std::istringstream vertices(between(text, "vertices\n(\n", ");\n"));
  char bracket = 0;
  int count = 0;
  for (Vec3 x; vertices >> bracket >> x.x >> x.y >> x.z >> bracket; ++count) {
    double nearest = 1;
    for (const Vec3 node : mesh.nodes) nearest = std::min(nearest, distance(node, x));
    EXPECT_LT(nearest, 1e-14);
  }
  EXPECT_EQ(count, 12);
}

TEST(BlockMeshHex, OtherSweepsAreRefused) {
  const auto twisted = [](Vec3 x) {
    return Vec3{x.x * std::cos(x.z) - x.y * std::sin(x.z), x.x * std::sin(x.z) + x.y * std::cos(x.z), x.z};
  };
  const auto along_a_curve = [](Vec3 x) { return Vec3{x.x + x.z * x.z, x.y, x.z}; };
  const auto tapered = [](Vec3 x) { return Vec3{x.x * (1 - x.z / 4), x.y * (1 - x.z / 4), x.z}; };
  const auto on_a_terrain = [](Vec3 x) { return Vec3{x.x, x.y, x.z + 0.1 * x.x * x.x}; };
  for (const std::function<Vec3(Vec3)>& map :
       std::vector<std::function<Vec3(Vec3)>>{twisted, along_a_curve, tapered, on_a_terrain})
    EXPECT_THROW(block_mesh_dict(two_hexes({.order = 2, .layers = 2, .map = map})), ComputeError);
}

}  // namespace
}  // namespace quadrille::exports
