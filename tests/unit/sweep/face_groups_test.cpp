#include <gtest/gtest.h>

#include "../region_layout_samples.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "sweep_samples.hpp"

namespace quadrille::sweep {
namespace {

TEST(FaceGroups, SidesHaveTheNamesOfCurvesAndEndsTheirOwn) {
  const HexMesh mesh = swept(quads(2), straight({0, 0, 1}), {0, 0.5, 1});
  ASSERT_EQ(mesh.face_groups.size(), 6u);
  const CadFace face = samples::face();
  EXPECT_EQ(mesh.face_groups[1].name, face.curve_names[1]);
  EXPECT_EQ(mesh.face_groups[1].elems, (std::vector<int>{1, 3}));
  EXPECT_EQ(mesh.face_groups[1].faces, (std::vector<int>{1, 1}));
  EXPECT_EQ(mesh.face_groups[4].name, "bottom");
  EXPECT_EQ(mesh.face_groups[5].name, "top");
  EXPECT_EQ(mesh.face_groups[5].elems, (std::vector<int>{2, 3}));
  SweepPlan plan;
  plan.top_name = face.curve_names[1];
  EXPECT_THROW(swept(quads(2), straight({0, 0, 1}), {0, 1}, plan), UsageError);
}

TEST(FaceGroups, EndsCanBePeriodic) {
  SweepPlan plan;
  plan.has_periodic_ends = true;
  SweepShape shape = straight({0, 0, 1});
  shape.twist = 1;
  const HexMesh mesh = swept(quads(3), shape, {0, 0.5, 1}, plan);
  EXPECT_EQ(mesh.face_groups[4].periodic_with, 5);
  expect_proved(mesh);
  shape.taper = 0.5;
  EXPECT_THROW(swept(quads(3), shape, {0, 1}, plan), UsageError);
}

TEST(FaceGroups, PeriodicSidesStayPeriodicWhereOneMotionDoes) {
  QuadMesh mesh = quads(2);
  mesh.face.periodic_pairs = {{{1, 3}, 0, {-1, 0}}};
  EXPECT_EQ(swept(mesh, straight({0.5, 0, 1}), {0, 1}).face_groups[1].periodic_with, 3);
  SweepShape twisted = straight({0, 0, 1});
  twisted.twist = 1;
  std::vector<std::string> lost;
  SweepPlan plan;
  plan.ends = {0, 1};
  EXPECT_EQ(sweep(mesh, SweepMotion(twisted), plan, 1, nullptr, lost).face_groups[1].periodic_with, -1);
  EXPECT_EQ(lost, std::vector<std::string>{mesh.face.curve_names[1]});
}

TEST(FaceGroups, InterfacesAreNamedFromBothSides) {
  SweepPlan plan;  // sides of the face are called bottom and top
  plan.bottom_name = "low", plan.top_name = "high";
  const HexMesh mesh = swept(samples::two_regions_quads(), straight({0, 0, 1}), {0, 1}, plan);
  EXPECT_EQ(mesh.region_names.size(), 2u);
  int interfaces = 0;
  for (const HexFaceGroup& group : mesh.face_groups) {
    if (!group.is_interface) continue;
    ++interfaces;
    EXPECT_EQ(group.elems.size() % 2, 0u);
  }
  EXPECT_EQ(interfaces, 1);
}

TEST(FaceGroups, CurvesWithoutANameHaveTheirNumberAndCurvesOfOneNameAreOneGroup) {
  QuadMesh mesh = quads(1);
  mesh.face.curve_names = {"wall", "", "wall", ""};
  const HexMesh hexes = swept(mesh, straight({0, 0, 1}), {0, 1});
  ASSERT_EQ(hexes.face_groups.size(), 5u);
  EXPECT_EQ(hexes.face_groups[0].name, "wall");
  EXPECT_EQ(hexes.face_groups[0].faces, (std::vector<int>{0, 0, 2, 2}));
  EXPECT_EQ(hexes.face_groups[1].name, "curve_1");
  EXPECT_EQ(hexes.face_groups[2].name, "curve_3");
}

TEST(FaceGroups, ANameOfAnEndThatASideHasIsRefused) {
  QuadMesh mesh = quads(1);
  mesh.face.curve_names[2] = "bottom";
  EXPECT_EQ(message_of<UsageError>([&] {
              swept(mesh, straight({0, 0, 1}), {0, 1});
            }),
            "'bottom' is the name of a side already: give --bottom-name");
}

/// Two sides of one name are one group, whose edges have several images.
TEST(FaceGroups, PeriodicSidesOfOneNameAreLost) {
  QuadMesh mesh = quads(1);
  mesh.face.periodic_pairs = {{{1, 3}, 0, {-1, 0}}};
  mesh.face.curve_names = {"bottom side", "wall", "top side", "wall"};
  std::vector<std::string> lost;
  SweepPlan plan;
  plan.ends = {0, 1};
  const HexMesh hexes = sweep(mesh, SweepMotion(straight({0, 0, 1})), plan, 1, nullptr, lost);
  EXPECT_EQ(lost, std::vector<std::string>{"wall"});
  for (const HexFaceGroup& group : hexes.face_groups) EXPECT_EQ(group.periodic_with, -1);
}

/// The motion of a sector of a disc is that of the plane in which the face lies in the CAD model.
TEST(FaceGroups, TheMotionOfAPairIsThatInTheModel) {
  QuadMesh mesh = quads(1);
  mesh.face.periodic_pairs = {{{1, 3}, 0, {-1, 0}}};
  mesh.face.plane_x = {0, 1, 0}, mesh.face.plane_y = {0, 0, 1};
  SweepShape shape = straight({2, 0, 0});
  shape.normal = {1, 0, 0};
  const HexMesh hexes = swept(mesh, shape, {0, 1});
  EXPECT_EQ(hexes.face_groups[1].periodic_with, 3);
  EXPECT_EQ(hexes.face_groups[1].motion.shift, (Vec3{0, -1, 0}));
}

}  // namespace
}  // namespace quadrille::sweep
