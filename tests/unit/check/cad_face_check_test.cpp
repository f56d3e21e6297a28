#include <gtest/gtest.h>

#include <limits>

#include "../samples.hpp"
#include "check/nurbs_rules.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

/// The rules that the square breaks once `damage` has been done to it.
template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::face(), check_cad_face, damage);
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

TEST(NurbsRules, AQuarterCircleIsRound) {
  const Nurbs arc{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1}};
  for (const double t : {0.0, 0.25, 0.5, 0.9, 1.0}) EXPECT_NEAR(norm(curve_point(arc, t)), 1, 1e-15);
  EXPECT_EQ(curve_point(arc, 0), (Vec2{1, 0}));
  EXPECT_EQ(curve_point(arc, 1), (Vec2{0, 1}));
}

}  // namespace
}  // namespace quadrille::check
