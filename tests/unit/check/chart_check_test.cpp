#include <gtest/gtest.h>

#include <limits>

#include "../chart_samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::charted_face(), [&](ChartedFace& charted) {
    Chart chart = *charted.face.chart;
    damage(chart);
    charted.face.chart = std::make_shared<const Chart>(std::move(chart));
  });
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ChartCheck, TheSampleIsValid) {
  for (const Violation& v : check_stage(samples::charted_face(), CheckDepth::full)) ADD_FAILURE() << v.rule << v.text;
}
TEST(ChartCheck, TheCapIsValid) {
  for (const Violation& v : check_stage(samples::charted_cap(), CheckDepth::full)) ADD_FAILURE() << v.rule << v.text;
}
TEST(ChartCheck, ChartsOfOtherStagesAreCheckedToo) {
  TriMesh mesh = samples::tri_mesh();
  Chart chart = *samples::sphere_face().chart;
  chart.uv.pop_back();
  mesh.face.chart = std::make_shared<const Chart>(chart);
  EXPECT_EQ(rules_of(check_stage(mesh, CheckDepth::quick)), Rules{"CHA-R02"});
}
TEST(ChartCheck, ChaR01ThereIsAChart) {
  EXPECT_EQ(broken_rules(samples::charted_face(), [](ChartedFace& c) { c.face.chart.reset(); }), Rules{"CHA-R01"});
}
TEST(ChartCheck, ChaR02ArraysAgree) {
  EXPECT_EQ(broken([](Chart& c) { c.order = 0; }), Rules{"CHA-R02"});
  EXPECT_EQ(broken([](Chart& c) { c.log_scale.pop_back(); }), Rules{"CHA-R02"});
  EXPECT_EQ(broken([](Chart& c) { c.space_curves.pop_back(); }), Rules{"CHA-R02"});
  EXPECT_EQ(broken([](Chart& c) { c.elem_surface[1] = 1; }), Rules{"CHA-R02"});
  EXPECT_EQ(broken([](Chart& c) { c.elem2vertices[1][0] = -1; }), Rules{"CHA-R02"});
}
TEST(ChartCheck, ChaR03SplinesAreSound) {
  EXPECT_EQ(broken([](Chart& c) { c.surfaces[0].poles.pop_back(); }), Rules{"CHA-R03"});
  EXPECT_EQ(broken([](Chart& c) { c.surfaces[0].weights[4] = 0; }), Rules{"CHA-R03"});
  EXPECT_EQ(broken([](Chart& c) { c.surfaces[0].degree_v = 0; }), Rules{"CHA-R03"});
  EXPECT_EQ(broken([](Chart& c) { c.surfaces[0].knots_u[5] = 0.4; }), Rules{"CHA-R03"});
  EXPECT_EQ(broken([](Chart& c) { c.space_curves[2].poles[1].z = nan; }), Rules{"CHA-R03"});
  EXPECT_EQ(broken([](Chart& c) { c.space_curves[2].degree = 3; }), Rules{"CHA-R03"});
}
TEST(ChartCheck, ChaR04NumbersAreFinite) {
  EXPECT_EQ(broken([](Chart& c) { c.nodes[3].y = nan; }), Rules{"CHA-R04"});
  EXPECT_EQ(broken([](Chart& c) { c.log_scale[3] = nan; }), Rules{"CHA-R04"});
  EXPECT_EQ(broken([](Chart& c) { c.closedness = 0.1; }), Rules{"CHA-R04"});
}
TEST(ChartCheck, ChaR05CurvesHaveTheirParametersAndMeet) {
  EXPECT_EQ(broken([](Chart& c) {
              for (double& knot : c.space_curves[1].knots) knot *= 1 + 1e-12;
            }),
            Rules{"CHA-R05"});
  EXPECT_TRUE(broken([](Chart& c) { c.space_curves[1].poles.back().z += 1e-3; }).contains("CHA-R05"));
}
TEST(ChartCheck, ChaR06ElementsAreValid) {
  EXPECT_TRUE(broken([](Chart& c) {
                for (int i = 0; i < c.nodes_per_elem(); ++i) std::swap(c.nodes[i].x, c.nodes[i].y);
              }).contains("CHA-R06"));
}
TEST(ChartCheck, ChaR07NodesLieOnTheirSurface) {
  EXPECT_EQ(broken([](Chart& c) { c.space_nodes[c.nodes_per_elem() - 1].z += 1e-4; }), Rules{"CHA-R07"});
  // Of 6 x 6 squares, the two triangles of one in the middle have no vertex on the boundary.
  ChartedFace fine = samples::charted_face();
  fine.face = samples::sphere_face(6, 3);
  Chart chart = *fine.face.chart;
  const auto off = [&](int elem) {
    Chart moved = chart;
    moved.space_nodes[(elem + 1) * chart.nodes_per_elem() - 1].z += 1e-8;
    fine.face.chart = std::make_shared<const Chart>(moved);
    return rules_of(check_stage(fine, CheckDepth::full));
  };
  EXPECT_EQ(off(2 * (2 * 6 + 2)), Rules{"CHA-R07"});
  EXPECT_EQ(off(0), Rules{}) << "edges of CAD files are not exactly on their surface";
  // The boundary is farther from the surface than nodes inside are.
  EXPECT_EQ(broken([](Chart& c) {
              for (Vec3& pole : c.surfaces[0].poles) pole.x *= 1 + 1e-3;
            }),
            Rules{});
}
TEST(ChartCheck, ChaR08ElementsShareTheirVertices) {
  EXPECT_TRUE(broken([](Chart& c) { std::swap(c.elem2vertices[0][0], c.elem2vertices[0][1]); }).contains("CHA-R08"));
}
TEST(ChartCheck, ChaR09OuterEdgesFollowTheCurvesInBothPlaces) {
  EXPECT_EQ(broken([](Chart& c) {
              for (std::size_t i = 0; i < 3; ++i) c.space_curves[0].poles[i] = -c.space_curves[0].poles[i];
            }).contains("CHA-R09"),
            true);
  EXPECT_EQ(broken([](Chart& c) { c.space_curves[0].poles[1].z += 0.01; }), Rules{"CHA-R09"});
}

TEST(ChartCheck, PeriodicSidesRepeatInSpace) {
  const auto broken_pair = [](std::array<int, 2> curves) {
    return broken_rules(samples::charted_face(), [&](ChartedFace& charted) {
      charted.face.periodic_pairs = {{curves, samples::pi / 2, {}}};
    });
  };
  EXPECT_EQ(broken_pair({0, 3}), Rules{});
  EXPECT_EQ(broken_pair({0, 1}), Rules{"FAC-R12"});
}

}  // namespace
}  // namespace quadrille::check
