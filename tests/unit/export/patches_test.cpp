#include "export/patches.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

using Types = std::vector<std::string>;

/// The types of the boundaries of two_quads(), whose curves below, right, above (bent) and left have these names.
Types types_of(const std::vector<std::string>& names, const std::vector<std::string>& options = {}) {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names = names;
  return patch_types(mesh, mesh_groups(mesh), patch_type_options(options));
}

TEST(PatchTypes, FollowFromTheBeginningOfTheName) {
  EXPECT_EQ(types_of({"wall", "Wall_2", "WALLS", "outer wall"}), (Types{"wall", "wall", "wall", "patch"}));
  EXPECT_EQ(types_of({"symmetry", "Symmetry_2", "symmetry top", "empty"}),
            (Types{"symmetryPlane", "symmetryPlane", "symmetry", "empty"}));
  EXPECT_EQ(types_of({"symmetry", "symmetry", "inlet", "wal"}), (Types{"symmetry", "patch", "patch"})) << "two lines";
}

TEST(PatchTypes, AnOptionDecides) {
  EXPECT_EQ(types_of({"inlet", "outlet", "wall", "wall"}, {"*let=wall", "inlet=symmetryPlane", "wall=patch"}),
            (Types{"symmetryPlane", "wall", "patch"}));
  EXPECT_EQ(types_of({"a=b", "c", "c", "c"}, {"a=b=wedge"}), (Types{"wedge", "patch"}));
}

TEST(PatchTypes, MistakesAreRefused) {
  const auto message = [](const std::string& option) {
    return message_of<UsageError>([&] { types_of({"inlet", "wall", "wall", "wall"}, {option}); });
  };
  EXPECT_EQ(message("lid=wall"), "--patch-type lid=wall: no boundary has this name; the boundaries are inlet, wall");
  EXPECT_EQ(message("inlet=cyclic"),
            "--patch-type inlet=cyclic: the type must be one of patch, wall, symmetryPlane, symmetry, empty, wedge");
  EXPECT_EQ(message("inlet"), "--patch-type inlet: expected NAME=TYPE, such as inlet=patch");
  EXPECT_NE(message("=wall"), "");
}

/// The two quads, of which the right side (curve 1) is the left one (curve 3) moved by 4.
QuadMesh periodic_quads(const std::vector<std::string>& names) {
  QuadMesh mesh = two_quads();
  mesh.face.curve_names = names;
  mesh.face.periodic_pairs = {{{3, 1}, 0, {4, 0}}};
  return mesh;
}

std::vector<int> neighbours(const std::vector<std::string>& names, const std::vector<PatchType>& chosen = {}) {
  const QuadMesh mesh = periodic_quads(names);
  std::vector<int> result;
  for (const CyclicPatch& patch : cyclic_patches(mesh, mesh_groups(mesh), chosen)) result.push_back(patch.neighbour);
  return result;
}

TEST(CyclicPatches, NameEachOther) {
  EXPECT_EQ(neighbours({"wall", "right", "wall", "left"}), (std::vector{-1, 2, 1}));
}

TEST(CyclicPatches, APatchWithOtherCurvesIsNotCyclic) {
  EXPECT_EQ(neighbours({"wall", "right", "left", "left"}), (std::vector{-1, -1, -1}));
  EXPECT_EQ(neighbours({"right", "right", "wall", "left"}), (std::vector{-1, -1, -1}));
  EXPECT_EQ(neighbours({"wall", "side", "wall", "side"}), (std::vector{-1, -1})) << "its own neighbour";
  const QuadMesh mesh = periodic_quads({"wall", "right", "left", "left"});
  const Exported exported = block_mesh_dict(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes.find("cyclic"), std::string::npos);
  EXPECT_NE(exported.losses.back().find("\"left\" and \"right\""), std::string::npos);
}

TEST(CyclicPatches, AnOptionDecides) {
  EXPECT_EQ(neighbours({"wall", "right", "wall", "left"}, {{"righ*", "wall"}}), (std::vector{-1, -1, -1}));
}

TEST(CyclicPatches, ABlockBetweenTwoFirstOrTwoSecondSidesCannotBeTurned) {
  for (const bool is_first : {false, true}) {
    std::vector<CyclicPatch> cyclic{{1, 0, is_first}, {0, 0, !is_first}, {3, 1, is_first}, {2, 1, !is_first}};
    PlateBlocks plates;
    plates.blocks.push_back({{0, 1, 2, 3}, 0, {}});
    plates.patches = {{{0, 1}}, {}, {{2, 3}}, {}};
    order_cyclic_blocks(QuadMesh(), Groups(), cyclic, plates);
    for (const CyclicPatch& patch : cyclic) EXPECT_EQ(patch.neighbour, -1);
  }
}

TEST(CyclicPatches, AllLengthsAreMetres) {
  QuadMesh mesh = periodic_quads({"wall", "right", "wall", "left"});
  mesh.face.metres_per_unit = 0.5;
  const std::string text = block_mesh_dict(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("scale 1;"), std::string::npos);
  EXPECT_NE(text.find("    (2 1 0.25)\n"), std::string::npos);
  EXPECT_NE(text.find(R"(    left
    {
        type cyclic;
        neighbourPatch right;
        transform translational;
        separationVector (2 0 0);
        separation (-2 0 0);
        faces
)"),
            std::string::npos);
}

TEST(CyclicPatches, ARotationHasItsCentre) {
  CadFace face;
  face.periodic_pairs = {{{0, 1}, std::numbers::pi / 2, {3, 1}}};  // (1, 2) -> (-2, 1) + (3, 1)
  const std::string text = cyclic_transform(face, {1, 0, true}, 10);
  double x = 0, y = 0;
  ASSERT_EQ(
      std::sscanf(text.c_str(), " transform rotational; rotationAxis (0 0 1); rotationCentre (%lf %lf 0);", &x, &y), 2);
  EXPECT_NEAR(x, 10, 1e-12);
  EXPECT_NEAR(y, 20, 1e-12);
}

}  // namespace

}  // namespace quadrille::exports
