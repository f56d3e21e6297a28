#include "offset/embed_offsets.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../chart_samples.hpp"
#include "base/error.hpp"
#include "curve/project.hpp"
#include "faces.hpp"
#include "model/name_rules.hpp"
#include "offset/wall_chains.hpp"
#include "outline/extent.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::offset {
namespace {

using namespace testing_faces;

CadFace with_offsets(const CadFace& face, const std::vector<std::string>& options, Report& report) {
  return embed_offsets(face, offset_requests(options), radians(1), {symmetry_pattern}, report);
}

CadFace with_offsets(const CadFace& face, const std::vector<std::string>& options) {
  Report report;
  return with_offsets(face, options, report);
}

std::vector<int> curves_named(const CadFace& face, const std::string& name) {
  std::vector<int> curves;
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.curve_names[c] == name) curves.push_back(c);
  return curves;
}

TEST(EmbedOffsets, AroundAHoleMakesARing) {
  CadFace plate = plate_with_hole();
  plate.unnamed_curves = {4};
  const CadFace face = with_offsets(plate, {"side_4=0.2"});
  EXPECT_EQ(face.num_regions(), 2);
  EXPECT_NEAR(outline::area(face), 8 - pi * 0.09, 1e-12);
  const std::vector<int> offsets = curves_named(face, "side_4_offset");
  ASSERT_EQ(offsets.size(), 2U);
  EXPECT_EQ(face.partners[offsets[0]], offsets[1]);
  const std::vector<int> hole = curves_named(face, "side_4");
  ASSERT_EQ(hole.size(), 1U) << "its name remains, its number does not";
  EXPECT_FALSE(face.has_given_name(hole[0]));
  EXPECT_TRUE(face.has_given_name(0));
  EXPECT_NEAR(curve::project(face.curves[offsets[0]], {1, 3}).distance, 1.5, 1e-12);
}

TEST(EmbedOffsets, CornersAreCutAndExtended) {
  const CadFace face = with_offsets(l_shape(), {"side_0,side_1,side_2,side_3,side_4,side_5=0.1"});
  ASSERT_EQ(face.num_regions(), 2);
  const auto has_joint = [&](Vec2 x) {
    return std::any_of(face.joints.begin(), face.joints.end(),
                       [&](const Joint& joint) { return distance(joint.position, x) < 1e-12; });
  };
  EXPECT_TRUE(has_joint({0.1, 0.1}));
  EXPECT_TRUE(has_joint({0.9, 0.9})) << "opposite to the corner of 270 degrees";
  EXPECT_EQ(face.num_curves(), 18);
}

TEST(EmbedOffsets, AnOpenWallEndsOnItsNeighbours) {
  const CadFace face = with_offsets(plate(), {"side_0=0.5"});
  EXPECT_EQ(face.num_regions(), 2);
  EXPECT_EQ(curves_named(face, "side_1").size(), 2U);
  EXPECT_EQ(curves_named(face, "side_3").size(), 2U);
}

TEST(EmbedOffsets, ASharpTailHasTwoCornersOppositeToIt) {
  // A wedge of 14 degrees whose tip points to the right.
  const CadFace face =
      hand_made::face({rectangle({-2, -2}, {4, 2}), polygon({{2, 0}, {0, -0.25}, {0, 0.25}})}, std::sqrt(52));
  const CadFace result = with_offsets(face, {"side_4,side_5,side_6=0.1"});
  int num_ahead = 0;
  for (const Joint& joint : result.joints) num_ahead += std::abs(joint.position.x - 2.1) < 1e-9;
  EXPECT_EQ(num_ahead, 4) << "two, seen from both regions";
}

TEST(EmbedOffsets, AHalfHasHalfOfTheCurveOfTheWhole) {
  // The upper half of that wedge: curves 0 and 4 are the line of symmetry, 5 and 6 the body.
  CadFace half =
      hand_made::face({polygon({{2, 0}, {4, 0}, {4, 2}, {-2, 2}, {-2, 0}, {0, 0}, {0, 0.25}})}, std::sqrt(40));
  for (const int curve : {0, 4}) hand_made::give_name(half, curve, "symmetry");
  const CadFace result = with_offsets(half, {"side_5,side_6=0.1"});
  ASSERT_EQ(result.num_regions(), 2);
  const auto count = [&](Vec2 x) {
    return std::count_if(result.joints.begin(), result.joints.end(),
                         [&](const Joint& joint) { return distance(joint.position, x) < 1e-9; });
  };
  EXPECT_EQ(count({2.1, 0}), 2);
  EXPECT_EQ(count({2.1, 0.1 * (std::sqrt(65) - 1) / 8}), 2) << "the corner of the whole's curve";
  EXPECT_EQ(count({-0.1, 0}), 2);
}

// A body with a blunt end, 0.1 high in the half: the distance is not limited by the line of symmetry beside it.
TEST(EmbedOffsets, NoLineOfSymmetryLimitsTheDistance) {
  CadFace half = hand_made::face({polygon({{2, 0}, {4, 0}, {4, 2}, {-2, 2}, {-2, 0}, {0, 0}, {0, 0.25}, {2, 0.1}})},
                                 std::sqrt(40));
  for (const int curve : {0, 4}) hand_made::give_name(half, curve, "symmetry");
  Report report;
  with_offsets(half, {"side_5,side_6,side_7=0.2"}, report);
  EXPECT_TRUE(report.warnings().empty());
  // Two bodies of the whole, 0.3 apart from each other: 0.35 of that over sqrt(2), in front of corners.
  CadFace upper =
      hand_made::face({rectangle({-2, 0}, {4, 2}), polygon({{0, 0.15}, {0, 1}, {2, 1}, {2, 0.15}})}, std::sqrt(40));
  hand_made::give_name(upper, 0, "symmetry");
  with_offsets(upper, {"side_4,side_5,side_6,side_7=0.2"}, report);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_NE(report.warnings().front().message.find("is reduced to 0.07425"), std::string::npos)
      << report.warnings().front().message;
}

TEST(EmbedOffsets, FacingWallsShareTheirGap) {
  const CadFace face = hand_made::face({rectangle({0, 0}, {10, 1})}, std::sqrt(101));
  Report report;
  const CadFace result = with_offsets(face, {"side_0,side_2=0.8"}, report);
  EXPECT_EQ(result.num_regions(), 3);
  ASSERT_EQ(report.warnings().size(), 2U);
  EXPECT_EQ(report.warnings().front().code, "W-CAD-009");
  for (const int c : curves_named(result, "side_0_offset"))
    EXPECT_NEAR(curve::project(result.curves[c], {5, 0}).distance, 0.35, 1e-6);
  const CadFace alone = with_offsets(face, {"side_0=0.8"});
  for (const int c : curves_named(alone, "side_0_offset"))
    EXPECT_NEAR(curve::project(alone.curves[c], {5, 0}).distance, 0.7, 1e-6) << "of a boundary that is no wall";
}

/// Both sides of each offset curve are the same in space, with the parameters of the chart, and on the unit sphere.
void expect_sound_on_sphere(const CadFace& face) {
  for (int c = 0; c < face.num_curves(); ++c) {
    const SpaceCurve &space = face.chart->space_curves[c], &next = face.chart->space_curves[face.next_in_loop(c)];
    EXPECT_EQ(space.poles.back(), next.poles.front());
    EXPECT_EQ(space.begin(), face.curves[c].begin());
    EXPECT_EQ(space.end(), face.curves[c].end());
    for (int i = 0; i <= 40; ++i) {
      const double t = space.begin() + (space.end() - space.begin()) * i / 40;
      const Vec3 x = surface::point(space, t);
      EXPECT_NEAR(norm(x), 1, 5e-12);
      EXPECT_NEAR(distance(x, samples::on_sphere(curve::point(face.curves[c], t))), 0, 1e-7);
    }
    if (const int other = face.partners[c]; other >= 0) {
      const SpaceCurve& back = face.chart->space_curves[other];
      EXPECT_TRUE(std::equal(space.poles.begin(), space.poles.end(), back.poles.rbegin(), back.poles.rend()));
    }
  }
}

TEST(EmbedOffsets, OnACurvedFaceTheDistanceIsThatInSpace) {
  const CadFace face = with_offsets(samples::cap_face(), {"axis=0.2"});
  EXPECT_EQ(face.num_regions(), 2);
  expect_sound_on_sphere(face);
  for (const int c : curves_named(face, "axis_offset"))
    for (int i = 0; i <= 40; ++i) {
      const Nurbs& curve = face.curves[c];
      const Vec2 x = curve::point(curve, curve.begin() + (curve.end() - curve.begin()) * i / 40);
      const double r = std::sqrt(1 + x.x * x.x);  // along the straight line of the chart across the axis
      EXPECT_NEAR(2 / r * std::atan(x.y / r), 0.2, 5e-7);
    }
  EXPECT_EQ(curves_named(face, "axis").size(), 1U);
  EXPECT_EQ(curves_named(face, "rim").size(), 4U) << "cut where the curve ends";
}

TEST(EmbedOffsets, OfRegionsOfACurvedFaceMeetOnTheirInterface) {
  const CadFace patch = samples::sphere_face(4, 8);
  const std::vector<std::string> names = patch.curve_names;
  const CadFace two = with_offsets(patch, {names[0] + "=0.3"});
  ASSERT_EQ(two.num_regions(), 2);
  const CadFace four = with_offsets(two, {names[1] + "=0.2"});
  EXPECT_EQ(four.num_regions(), 4);
  expect_sound_on_sphere(four);
  EXPECT_EQ(curves_named(four, names[1] + "_offset").size(), 6U) << "two curves and, in one region, an extension";
  EXPECT_EQ(curves_named(four, names[0] + "_offset").size(), 4U) << "cut once, seen from both sides";
  EXPECT_EQ(four.num_curves(), 18);
}

TEST(EmbedOffsets, MistakesAreRefused) {
  EXPECT_THROW(with_offsets(plate(), {"side_0=1e-9"}), UsageError);
  EXPECT_THROW(with_offsets(plate(), {"hole=0.1"}), UsageError);
  CadFace periodic = plate();
  periodic.periodic_pairs.push_back({{1, 3}, 0, {-4, 0}});
  EXPECT_THROW(with_offsets(periodic, {"side_0=0.1"}), UsageError);
}

}  // namespace
}  // namespace quadrille::offset
