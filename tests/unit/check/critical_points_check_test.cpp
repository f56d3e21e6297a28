#include <gtest/gtest.h>

#include <limits>

#include "../region_samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

constexpr int least = std::numeric_limits<int>::min();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::critical_points(), damage);
}

TEST(CriticalPointsCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](CriticalPoints&) {}), Rules{});
}

TEST(CriticalPointsCheck, CrtR01NumbersAreFinite) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].position.x = std::numeric_limits<double>::quiet_NaN(); }),
            Rules{"CRT-R01"});
  EXPECT_EQ(broken([](auto& c) { c.corners[0].angle_degrees = std::numeric_limits<double>::infinity(); }),
            Rules{"CRT-R01"});
}
TEST(CriticalPointsCheck, CrtR02ValencesFitIndices) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].index = 2; }), Rules{"CRT-R02"});
}
TEST(CriticalPointsCheck, CrtR03ElementsAreSound) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].elem = -1; }), Rules{"CRT-R03"});
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].xi = {0.5, 0.5}; }), Rules{"CRT-R03"});
}
TEST(CriticalPointsCheck, CrtR04CornersAreSound) {
  EXPECT_EQ(broken([](auto& c) { c.corners[1].joint = 0; }), Rules{"CRT-R04"});
  EXPECT_EQ(broken([](auto& c) { c.corners[1].curves[0] = -1; }), Rules{"CRT-R04"});
  EXPECT_EQ(broken([](auto& c) { c.corners[1].angle_degrees = 360; }), Rules{"CRT-R04"});
}
TEST(CriticalPointsCheck, CrtR05IndexSumIsTheSum) {
  EXPECT_EQ(broken([](auto& c) { c.corners[2].valence = 2; }), Rules{"CRT-R05"});
}
TEST(CriticalPointsCheck, CrtR06IndexSumIsFourChi) {
  EXPECT_EQ(broken([](auto& c) { c.index_sum_expected = 0; }), Rules{"CRT-R06"});
  EXPECT_EQ(broken([](auto& c) {
              c.index_sum_expected = c.index_sum = 3;
              c.corners[2].valence = 2;
            }),
            Rules{"CRT-R06"});
}
TEST(CriticalPointsCheck, CrtR07JacobiansFitIndices) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[1].jacobian = {1, 0, 0, 1}; }), Rules{"CRT-R07"});
}
TEST(CriticalPointsCheck, CrtR08PointsDiffer) {
  EXPECT_EQ(broken([](auto& c) {
              c.critical_points[1].position = c.critical_points[0].position + Vec2{1e-12, 0};
            }),
            Rules{"CRT-R08"});
  EXPECT_EQ(broken([](auto& c) { c.critical_points[1].position = c.critical_points[0].position; }), Rules{"CRT-R08"});
}

TEST(CriticalPointsCheck, AnAskedValenceOfAnySizeIsRefusedWithoutOverflow) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].valence = least; }), (Rules{"CRT-R02", "CRT-R05"}));
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].index = least; }), Rules{"CRT-R02"});
  EXPECT_EQ(broken([](auto& c) { c.corners[0].valence = least; }), (Rules{"CRT-R04", "CRT-R05"}));
}

template <typename Damage>
Rules broken_beside_field(const Damage& damage) {
  CriticalPoints points = samples::critical_points();
  damage(points);
  return rules_of(check_critical_points_of(points, samples::field().mesh));
}

TEST(CriticalPointsCheck, TheSampleFitsItsField) {
  EXPECT_EQ(broken_beside_field([](CriticalPoints&) {}), Rules{});
}

TEST(CriticalPointsCheck, CrtR09ElementsExistInTheField) {
  EXPECT_EQ(broken_beside_field([](auto& c) { c.critical_points[0].elem = 4; }), Rules{"CRT-R09"});
}
TEST(CriticalPointsCheck, CrtR10CornersAreTheFaces) {
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners.pop_back(); }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners.push_back(c.corners[3]); }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners[1].joint = 2; }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners[1].curves = {1, 0}; }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners[1].position.x += 0.1; }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners[1].angle_degrees = 91; }), Rules{"CRT-R10"});
}
TEST(CriticalPointsCheck, CrtR11ErrorsAreNotNegative) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].error = -1e-9; }), Rules{"CRT-R11"});
}

/// The sample whose nodes are not the field's zeros.
template <typename Damage>
Rules broken_resolved(const Damage& damage) {
  CriticalPoints points = samples::resolved_points();
  damage(points);
  return rules_of(check_stage(points, CheckDepth::full));
}

template <typename Damage>
Rules broken_resolved_beside_field(const Damage& damage) {
  CriticalPoints points = samples::resolved_points();
  damage(points);
  return rules_of(check_critical_points_of(points, samples::field().mesh));
}

TEST(CriticalPointsCheck, TheResolvedSampleIsValid) {
  EXPECT_EQ(broken_resolved([](CriticalPoints&) {}), Rules{});
  EXPECT_EQ(broken_resolved_beside_field([](CriticalPoints&) {}), Rules{});
}

TEST(CriticalPointsCheck, CrtR01NumbersOfEveryListAreFinite) {
  EXPECT_EQ(broken_resolved([](auto& c) { c.zeros[1].jacobian[2] = not_a_number; }), Rules{"CRT-R01"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.boundary_nodes[0].t = not_a_number; }), Rules{"CRT-R01"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.clusters[0].members[0].x = not_a_number; }), Rules{"CRT-R01"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.changes[1].after[0].position.y = not_a_number; }), Rules{"CRT-R01"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.certificate.cells[0].vertices[5] = not_a_number; }), Rules{"CRT-R01"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.certificate.disc_radii[0] = not_a_number; }), Rules{"CRT-R01"});
}
TEST(CriticalPointsCheck, CrtR05IndexSumCountsBoundaryNodes) {
  EXPECT_EQ(broken_resolved([](auto& c) { c.boundary_nodes.clear(); }), Rules{"CRT-R05"});
}
TEST(CriticalPointsCheck, CrtR12FormsAreKnown) {
  EXPECT_EQ(broken([](auto& c) { c.hole_winding_offsets = {1}; }), Rules{"CRT-R12"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.form = NodeForm::harmonic; }), Rules{"CRT-R12"});
}
TEST(CriticalPointsCheck, CrtR13BoundaryNodesAndHoleWindingOffsetsAreSound) {
  EXPECT_EQ(broken_resolved([](auto& c) { c.boundary_nodes[0].curve = -1; }), Rules{"CRT-R13"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.hole_winding_offsets = {2000000}; }), Rules{"CRT-R13"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.hole_winding_offsets = {least}; }), Rules{"CRT-R13"});
  for (const int regular_or_worse : {-1, 0, 2, 5, least}) {
    const Rules rules = broken_resolved([&](auto& c) { c.boundary_nodes[0].valence = regular_or_worse; });
    EXPECT_EQ(rules, (Rules{"CRT-R05", "CRT-R13"})) << regular_or_worse;
  }
  EXPECT_EQ(broken_resolved([](auto& c) {
              c.boundary_nodes.push_back(c.boundary_nodes[0]);
              c.critical_points[0].valence = 2;
              c.critical_points[0].index = 2;
            }),
            Rules{"CRT-R13"});
}
TEST(CriticalPointsCheck, CrtR14BoundaryNodesLieOnTheirCurves) {
  EXPECT_EQ(broken_resolved_beside_field([](auto& c) { c.boundary_nodes[0].curve = 4; }), Rules{"CRT-R14"});
  EXPECT_EQ(broken_resolved_beside_field([](auto& c) { c.boundary_nodes[0].t = 1.5; }), Rules{"CRT-R14"});
  EXPECT_EQ(broken_resolved_beside_field([](auto& c) { c.boundary_nodes[0].t = 0.25; }), Rules{"CRT-R14"});
  EXPECT_EQ(broken_resolved_beside_field([](auto& c) { c.hole_winding_offsets = {0}; }), Rules{"CRT-R14"})
      << "the square has no hole";
}
TEST(CriticalPointsCheck, CrtR15WhatTheSearchFoundIsSound) {
  EXPECT_EQ(broken_resolved([](auto& c) { c.zeros[0].elem = -1; }), Rules{"CRT-R15"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.zeros[0].error = -1; }), Rules{"CRT-R15"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.clusters[0].radius = -1; }), Rules{"CRT-R15"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.clusters[0].member_indices = {1, 1}; }), Rules{"CRT-R15"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.clusters[0].member_indices = {1}; }), Rules{"CRT-R15"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.certificate.cells_excluded = -1; }), Rules{"CRT-R15"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.certificate.cells[0].elem = -1; }), Rules{"CRT-R15"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.certificate.disc_radii.pop_back(); }), Rules{"CRT-R15"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.certificate.disc_radii[0] = -1; }), Rules{"CRT-R15"});
}
TEST(CriticalPointsCheck, CrtR16ChangesKeepTheIndexSum) {
  EXPECT_EQ(broken_resolved([](auto& c) { c.changes[0].after.pop_back(); }), Rules{"CRT-R16"});
  EXPECT_EQ(broken_resolved([](auto& c) { c.changes[2].after[0].location = NodeLocation::inside; }), Rules{"CRT-R16"});
  EXPECT_EQ(broken_resolved([](auto& c) {
              c.changes = {{ChangeKind::line, "no zeros were there", {}, {{{0, 0}, 1, NodeLocation::corner}}}};
            }),
            Rules{});
}

template <typename Damage>
Rules broken_regions(const Damage& damage) {
  return broken_rules(samples::two_regions_points(), damage);
}

TEST(CriticalPointsCheck, PointsOfRegionsAreValid) {
  EXPECT_EQ(broken_regions([](auto&) {}), Rules{});
  EXPECT_EQ(rules_of(check_critical_points_of(samples::two_regions_points(), samples::two_regions_field().mesh)),
            Rules{});
}
TEST(CriticalPointsCheck, CrtR06EachRegionCounts) {
  EXPECT_EQ(broken_regions([](auto& c) {
              c.index_sum_expected = c.index_sum = 4;
              for (std::size_t i = 0; i < 4; ++i) c.corners[i].valence = 2;
            }),
            Rules{"CRT-R06"})
      << "4, but there are two regions";
  EXPECT_EQ(broken_regions([](auto& c) { c.face = {}; }), Rules{"CRT-R06"}) << "without a face there is one region";
}
TEST(CriticalPointsCheck, CrtR04ASlitEndsInACornerOf360Degrees) {
  CriticalPoints points;
  points.face = samples::slit_face();
  for (int j = 0; j < 6; ++j) {
    const Joint& joint = points.face.joints[static_cast<std::size_t>(j)];
    const bool is_tip = j > 3;
    points.corners.push_back(
        {j, joint.position, is_tip ? 360.0 : 90.0, is_tip ? 4 : 1, {points.face.previous_in_loop(j), j}});
  }
  const auto check = [&](auto&& damage) { return broken_rules(points, damage); };
  EXPECT_EQ(check([](auto&) {}), Rules{});
  EXPECT_EQ(check([](auto& c) { c.corners[0].angle_degrees = 360; }), Rules{"CRT-R04"});
  EXPECT_EQ(check([](auto& c) { c.corners[5].joint = 6; }), Rules{"CRT-R04"}) << "no such joint";
  EXPECT_EQ(check([](auto& c) { c.face.loop_offsets = {0, 1, 9}; }), Rules{"FAC-R02"});
}
TEST(CriticalPointsCheck, CrtR14HolesAreCountedInEachRegion) {
  CriticalPoints points = samples::two_regions_points();
  points.form = NodeForm::phase;
  points.hole_winding_offsets = {0};
  EXPECT_EQ(rules_of(check_critical_points_of(points, samples::two_regions_field().mesh)), Rules{"CRT-R14"})
      << "two loops, but no hole";
}

}  // namespace
}  // namespace quadrille::check
