#include "export/translate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "model/periodic.hpp"

namespace quadrille::exports {
namespace {

TEST(Translate, ReadsTwoOrThreeNumbers) {
  EXPECT_EQ(parse_translation(""), std::vector<double>{});
  EXPECT_EQ(parse_translation("1,-2.5"), (std::vector<double>{1, -2.5}));
  EXPECT_EQ(parse_translation("1,2,3"), (std::vector<double>{1, 2, 3}));
  for (const char* text : {"1", "1,2,3,4", "1,x", "1,,2"}) EXPECT_THROW(parse_translation(text), UsageError) << text;
}

TEST(Translate, ThreeNumbersAreForSpace) {
  EXPECT_THROW(require_translation({1, 2, 3}, false), UsageError);
  EXPECT_NO_THROW(require_translation({1, 2, 3}, true));
  QuadMesh mesh;
  EXPECT_THROW(translate(mesh, {1, 2, 3}, false), UsageError);
}

TEST(Translate, InThePlaneMovesTheOriginAndInSpaceThePlane) {
  QuadMesh mesh;
  mesh.face.origin = {1, 2};
  translate(mesh, {10, 20}, false);
  EXPECT_EQ(mesh.face.origin, (Vec2{11, 22}));
  translate(mesh, {1, 2, 3}, true);
  EXPECT_EQ(mesh.face.origin, (Vec2{11, 22}));
  EXPECT_EQ(mesh.face.plane_origin, (std::array<double, 3>{1, 2, 3}));
}

TEST(Translate, KeepsPeriodicSidesOnEachOther) {
  QuadMesh mesh;
  mesh.face.origin = {1, 2};
  mesh.face.periodic_pairs = {{{0, 1}, 0.7, {0.3, -0.4}}};
  const PeriodicMotion before(mesh.face.periodic_pairs[0], mesh.face.origin);
  translate(mesh, {10, 20}, false);
  const PeriodicMotion after(mesh.face.periodic_pairs[0], mesh.face.origin);
  const Vec2 x{0.2, 5};  // relative to the origin: the same point of the mesh before and after
  EXPECT_LT(distance(before.image(x), after.image(x)), 1e-14);
}

TEST(Translate, HexahedraMoveInSpaceWithTheMotionsOfTheirEnds) {
  HexMesh mesh;
  mesh.nodes = {{1, 0, 0}, {0, 1, 4}};
  SpaceMotion turn{{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}, {0, 0, 4}};  // the first node to the second
  mesh.face_groups = {{.name = "bottom", .periodic_with = 1, .motion = turn}};
  translate(mesh, {5, 6, 7}, false);
  EXPECT_EQ(mesh.nodes[1], (Vec3{5, 7, 11}));
  const SpaceMotion& motion = mesh.face_groups[0].motion;
  const auto& [a, b, c] = motion.matrix;
  const Vec3 x = mesh.nodes[0];
  EXPECT_LT(distance(Vec3{dot(a, x), dot(b, x), dot(c, x)} + motion.shift, mesh.nodes[1]), 1e-14);
}

}  // namespace
}  // namespace quadrille::exports
