#include "export/hex_periodic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "surface/periodic_motion.hpp"
#include "two_hexes.hpp"

namespace quadrille::exports {
namespace {

HexMesh joined(const TwoHexes& shape) {
  HexMesh mesh = two_hexes(shape);
  join_ends(mesh, shape.layers);
  return mesh;
}

TEST(PeriodicFaces, NodesAreImagesWhateverTheCornerAtWhichAFaceBegins) {
  for (int corner = 0; corner < 4; ++corner) {
    const HexMesh mesh = joined({.order = 3, .layers = 2, .first_corner = corner});
    const std::vector<PeriodicFaces> pairs = periodic_faces(mesh);
    ASSERT_EQ(pairs.size(), 2u);
    for (const PeriodicFaces& pair : pairs) {
      EXPECT_EQ(pair.group, 3);
      EXPECT_EQ(pair.nodes.size(), 16u);
      for (const auto& [node, image] : pair.nodes)
        EXPECT_LT(distance(mesh.nodes[node] + Vec3{0, 0, 2}, mesh.nodes[image]), 1e-14);
    }
  }
}

TEST(PeriodicFaces, GroupsThatNameEachOtherAreOnePair) {
  HexMesh mesh = joined({});
  mesh.face_groups[4].periodic_with = 3;
  mesh.face_groups[4].motion.shift = {0, 0, -1};
  EXPECT_EQ(periodic_faces(mesh).size(), 2u);
  EXPECT_EQ(periodic_faces(mesh)[1].group, 3);
  mesh.face_groups[3].periodic_with = -1;
  EXPECT_EQ(periodic_faces(mesh)[0].group, 4) << "the only one that names the other";
}

TEST(PeriodicFaces, AFaceWithoutAnImageIsRefusedWithThePlace) {
  HexMesh mesh = joined({});
  mesh.face_groups[3].motion.shift.x = 1e-8;
  EXPECT_EQ(message_of<ComputeError>([&] { periodic_faces(mesh); }),
            "no face of the other periodic side is the image of the face at (0, 2, 0): make the mesh again (hexsweep)");
  mesh.face_groups[3].motion.shift.x = 1e-10;
  EXPECT_EQ(periodic_faces(mesh).size(), 2u) << "within 1e-9 diameters";
}

TEST(PeriodicLoss, NamesThePairs) {
  EXPECT_EQ(periodic_loss(two_hexes({})), "");
  EXPECT_EQ(periodic_loss(joined({})),
            "that faces are periodic is not stored, their nodes are images of each other: \"bottom\" and \"top\"");
  EXPECT_TRUE(periodic_loss(joined({}), "because").ends_with("\"top\" (because)"));
}

TEST(IsTranslation, NeedsTheUnitMatrix) {
  SpaceMotion motion;
  motion.shift = {1, 2, 3};
  EXPECT_TRUE(is_translation(motion));
  motion.matrix[0].y = 1e-300;
  EXPECT_FALSE(is_translation(motion));
}

TEST(PeriodicVertices, ThreeLayersAreNeededToKnowEdgesByTheirVertices) {
  const auto of_layers = [](int layers) {
    const HexMesh mesh = joined({.layers = layers});
    return periodic_vertices(mesh, number_parts(mesh), Motions::all, "MFEM");
  };
  const PeriodicVertices three = of_layers(3);
  EXPECT_EQ(three.loss, "");
  ASSERT_EQ(three.same.size(), 24u);
  const HexMesh mesh = joined({.layers = 3});
  const HexNumbering numbering = number_parts(mesh);
  std::map<std::pair<double, double>, std::set<int>> joined_ends;
  for (int v = 0; v < 24; ++v)
    if (const Vec3 x = mesh.nodes[numbering.vertices[v]]; x.z == 0 || x.z == 3)
      joined_ends[{x.x, x.y}].insert(three.same[v]);
  EXPECT_EQ(joined_ends.size(), 6u);
  for (const auto& [place, same] : joined_ends) EXPECT_EQ(same.size(), 1u);
  for (const int layers : {1, 2}) {
    EXPECT_TRUE(of_layers(layers).same.empty()) << layers;
    expect_contains(of_layers(layers).loss, "MFEM identifies edges and faces by their vertices");
  }
}

TEST(PeriodicVertices, RotationsCountIfTheyAreAskedFor) {
  HexMesh mesh = two_hexes({.layers = 3, .map = [](Vec3 x) {
                              const double angle = std::acos(-1.0) / 6 * x.z;  // a quarter turn
                              return Vec3{(3 + x.x) * std::cos(angle), (3 + x.x) * std::sin(angle), -x.y};
                            }});
  mesh.face_groups[3].periodic_with = 4;
  mesh.face_groups[3].motion.matrix = {Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
  const HexNumbering numbering = number_parts(mesh);
  EXPECT_EQ(periodic_vertices(mesh, numbering, Motions::all, "x").same.size(), 24u);
  const PeriodicVertices translations = periodic_vertices(mesh, numbering, Motions::translations, "x");
  EXPECT_TRUE(translations.same.empty() && translations.loss.empty());
}

}  // namespace
}  // namespace quadrille::exports
