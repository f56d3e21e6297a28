#include <gtest/gtest.h>

#include <limits>

#include "../region_samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

/// The rules that the square breaks once `damage` has been done to it.
template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::face(), damage);
}

TEST(CadFaceCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](CadFace&) {}), Rules{});
}

TEST(CadFaceCheck, FacR01NamesForEachCurve) {
  EXPECT_EQ(broken([](CadFace& f) { f.curve_names.pop_back(); }), Rules{"FAC-R01"});
  EXPECT_EQ(broken([](CadFace& f) { f.joints.push_back({}); }), Rules{"FAC-R01"});
  EXPECT_EQ(broken([](CadFace& f) { f = CadFace{}; }), Rules{"FAC-R01"});
  EXPECT_EQ(broken([](CadFace& f) { f.unnamed_curves = {0, 3}; }), Rules{});
  for (const std::vector<int>& wrong : std::vector<std::vector<int>>{{4}, {-1}, {2, 1}, {1, 1}})
    EXPECT_EQ(broken([&](CadFace& f) { f.unnamed_curves = wrong; }), Rules{"FAC-R01"});
}
TEST(CadFaceCheck, FacR02LoopOffsetsClimb) {
  EXPECT_EQ(broken([](CadFace& f) { f.loop_offsets = {0, 3}; }), Rules{"FAC-R02"});
  EXPECT_EQ(broken([](CadFace& f) { f.loop_offsets = {0, 5, 4}; }), Rules{"FAC-R02"});
  EXPECT_EQ(broken([](CadFace& f) { f.loop_offsets = {}; }), Rules{"FAC-R02"});
}
TEST(CadFaceCheck, FacR03CurveArraysFit) {
  EXPECT_EQ(broken([](CadFace& f) { f.curves[1].knots.pop_back(); }), Rules{"FAC-R03"});
  EXPECT_EQ(broken([](CadFace& f) { f.curves[1].degree = 0; }), Rules{"FAC-R03"});
  EXPECT_EQ(broken([](CadFace& f) { f.curves[1].poles.clear(); }), Rules{"FAC-R03"});
  EXPECT_EQ(broken([](CadFace& f) { f.curves[1].weights.push_back(1); }), Rules{"FAC-R03"});
}
TEST(CadFaceCheck, FacR04CurvesAreClampedFiniteAndPositive) {
  EXPECT_EQ(broken([](CadFace& f) { f.curves[2].weights[1] = 0; }), Rules{"FAC-R04"});
  EXPECT_EQ(broken([](CadFace& f) { f.curves[2].weights[1] = 1e9; }), Rules{"FAC-R04"});
  EXPECT_EQ(broken([](CadFace& f) { f.curves[2].knots[1] = 0.5; }), Rules{"FAC-R04"});
  EXPECT_EQ(broken([](CadFace& f) { f.curves[2].knots = {0, 0, 0, 0}; }), Rules{"FAC-R04"});
  EXPECT_EQ(broken([](CadFace& f) { f.curves[2].poles[0].x = std::numeric_limits<double>::quiet_NaN(); }),
            Rules{"FAC-R04"});
}
TEST(CadFaceCheck, FacR05NumbersAreFinite) {
  EXPECT_EQ(broken([](CadFace& f) { f.diameter = 0; }), Rules{"FAC-R05"});
  EXPECT_EQ(broken([](CadFace& f) { f.fit_distance = -1e-9; }), Rules{"FAC-R05"});
  EXPECT_EQ(broken([](CadFace& f) { f.origin.x = std::numeric_limits<double>::infinity(); }), Rules{"FAC-R05"});
  EXPECT_EQ(broken([](CadFace& f) { f.joints[0].tangent_in = std::numeric_limits<double>::quiet_NaN(); }),
            Rules{"FAC-R05"});
}
TEST(CadFaceCheck, FacR06CurvesMeet) {
  EXPECT_EQ(broken([](CadFace& f) { f.curves[3].poles[1] = {0, 0.001}; }), Rules{"FAC-R06"});
  EXPECT_EQ(broken([](CadFace& f) { f.joints[2].position.x += 0.001; }), Rules{"FAC-R06"});
  EXPECT_EQ(broken([](CadFace& f) {
              f.curves[3] = {2, {0, 0, 0, 1, 1, 1}, {{0, 1}, {0, 1e4}, {0, 0}}, {1, 1, 1}};
            }),
            (Rules{"FAC-R06", "FAC-R10"}));
}
TEST(CadFaceCheck, FacR07AnglesAgree) {
  EXPECT_EQ(broken([](CadFace& f) { f.joints[1].interior_angle = 1; }), Rules{"FAC-R07"});
  EXPECT_EQ(broken([](CadFace& f) { f.joints[1].interior_angle = -samples::pi / 2; }), Rules{"FAC-R07"});
}
TEST(CadFaceCheck, FacR08PlaneIsOrthonormal) {
  EXPECT_EQ(broken([](CadFace& f) { f.plane_y = {0, 2, 0}; }), Rules{"FAC-R08"});
  EXPECT_EQ(broken([](CadFace& f) { f.plane_y = {1, 0, 0}; }), Rules{"FAC-R08"});
  EXPECT_EQ(broken([](CadFace& f) { f.metres_per_unit = -1; }), Rules{"FAC-R08"});
}
TEST(CadFaceCheck, FacR09OutlineIsCounterClockwise) {
  EXPECT_EQ(broken([](CadFace& f) {
              // The mirror image, walked as before: everything else still fits.
              for (Nurbs& c : f.curves)
                for (Vec2& p : c.poles) p.x = -p.x;
              for (Joint& j : f.joints) {
                j.position.x = -j.position.x;
                j.tangent_in = std::remainder(samples::pi - j.tangent_in, 2 * samples::pi);
                j.tangent_out = std::remainder(samples::pi - j.tangent_out, 2 * samples::pi);
                j.interior_angle = 2 * samples::pi - j.interior_angle;
              }
            }),
            Rules{"FAC-R09"});
}
TEST(CadFaceCheck, FacR10TangentsAreTheCurvesOwn) {
  EXPECT_EQ(broken([](CadFace& f) {
              f.joints[1].tangent_in += 0.1;
              f.joints[1].tangent_out += 0.1;
            }),
            Rules{"FAC-R10"});
}

template <typename Damage>
Rules broken_regions(const Damage& damage) {
  return broken_rules(samples::two_regions_face(), damage);
}
template <typename Damage>
Rules broken_slit(const Damage& damage) {
  return broken_rules(samples::slit_face(), damage);
}

TEST(CadFaceCheck, RegionsAndSlitsAreValid) {
  EXPECT_EQ(broken_regions([](CadFace&) {}), Rules{});
  EXPECT_EQ(broken_slit([](CadFace&) {}), Rules{});
}
TEST(CadFaceCheck, FacR01ArraysOfRegions) {
  EXPECT_EQ(broken_regions([](CadFace& f) { f.partners.pop_back(); }), Rules{"FAC-R01"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.partners.clear(); }), Rules{"FAC-R01"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.partners[1] = 8; }), Rules{"FAC-R01"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.partners[0] = -2; }), Rules{"FAC-R01"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.region_names.pop_back(); }), Rules{"FAC-R01"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.periodic_pairs[1].curves = {4, 8}; }), Rules{"FAC-R01"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.periodic_pairs[1].curves = {-1, 6}; }), Rules{"FAC-R01"});
}
TEST(CadFaceCheck, FacR02RegionLoopsClimb) {
  for (const std::vector<int>& wrong : std::vector<std::vector<int>>{{0, 2, 2}, {0, 1, 3}, {1, 1, 2}, {0, 3, 2}})
    EXPECT_EQ(broken_regions([&](CadFace& f) { f.region_loops = wrong; }), Rules{"FAC-R02"});
  EXPECT_EQ(broken([](CadFace& f) { f.region_loops = {0}; }), Rules{"FAC-R02"});
  EXPECT_EQ(broken([](CadFace& f) { f.region_loops = {0, 1}; }), Rules{});
}
TEST(CadFaceCheck, FacR05MotionsAreFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(broken_regions([&](CadFace& f) { f.periodic_pairs[0].angle = infinity; }), Rules{"FAC-R05"});
  EXPECT_EQ(broken_regions([&](CadFace& f) { f.periodic_pairs[0].shift.y = infinity; }), Rules{"FAC-R05"});
}
TEST(CadFaceCheck, FacR07SlitsEndInFullCircles) {
  EXPECT_EQ(broken_slit([](CadFace& f) { f.joints[5].interior_angle = 0; }), Rules{"FAC-R07"});
}
TEST(CadFaceCheck, FacR09EachRegionHasAnOutlineFirst) {
  EXPECT_EQ(broken_regions([](CadFace& f) {
              f.region_loops = {};
              f.region_names = {};
            }),
            Rules{"FAC-R09"})
      << "a hole of one region must be clockwise";
  EXPECT_EQ(broken_slit([](CadFace& f) {
              f.region_loops = {0, 1, 2};
              f.region_names = {"a", "b"};
            }),
            Rules{"FAC-R09"})
      << "a slit encloses no region";
}
TEST(CadFaceCheck, FacR11PartnersAreOneCurve) {
  EXPECT_EQ(broken_regions([](CadFace& f) { f.partners[7] = -1; }), Rules{"FAC-R11"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.partners[1] = f.partners[7] = -1; }), Rules{});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.partners[5] = 5; }), Rules{"FAC-R11"});
  EXPECT_EQ(broken_regions([](CadFace& f) {
              f.partners[1] = 5;
              f.partners[5] = 1;
              f.partners[7] = -1;
            }),
            Rules{"FAC-R11"})
      << "two curves in different places";
  EXPECT_EQ(broken_regions([](CadFace& f) { f.curves[7].poles[0].x += 4e-16; }), Rules{"FAC-R11"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.curves[7].weights[0] = 0.5; }), Rules{"FAC-R11"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.curves[7].knots = {0, 0, 2, 2}; }), Rules{"FAC-R11"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.curve_names[7] = "solid-fluid"; }), Rules{"FAC-R11"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.unnamed_curves = {1}; }), Rules{"FAC-R11"});
}
TEST(CadFaceCheck, FacR12MotionsMapTheFirstCurveOntoTheSecond) {
  EXPECT_EQ(broken_regions([](CadFace& f) { f.periodic_pairs[0].shift = {0, 1.001}; }), Rules{"FAC-R12"});
  EXPECT_EQ(broken_regions([](CadFace& f) { f.periodic_pairs[0].curves = {0, 6}; }), Rules{"FAC-R12"});
  EXPECT_EQ(broken_regions([](CadFace& f) {
              f.periodic_pairs = {{{3, 1}, 0, {1, 0}}};
            }),
            Rules{"FAC-R12"})
      << "an interface is not periodic";
  EXPECT_EQ(broken_regions([](CadFace& f) { f.periodic_pairs.push_back(f.periodic_pairs[0]); }), Rules{"FAC-R12"});
  // A quarter turn about (0, 0) maps the lower side of the left square onto its left side; the origin is added.
  EXPECT_EQ(broken_regions([](CadFace& f) { f.periodic_pairs = {{{0, 3}, samples::pi / 2, {0, 0}}}; }), Rules{});
  EXPECT_EQ(broken_regions([](CadFace& f) {
              f.origin = {2, 0};
              f.periodic_pairs = {{{0, 3}, samples::pi / 2, {2, -2}}};
            }),
            Rules{});
  EXPECT_EQ(broken_regions([](CadFace& f) {
              f.origin = {2, 0};
              f.periodic_pairs = {{{0, 3}, samples::pi / 2, {0, 0}}};
            }),
            Rules{"FAC-R12"});
}

}  // namespace
}  // namespace quadrille::check
