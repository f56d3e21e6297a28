#include "layout/trace_separatrices.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "base/error.hpp"
#include "graph/candidate_layout.hpp"
#include "trace/launch.hpp"
#include "trace/launch_directions.hpp"

namespace quadrille::layout {
namespace {

const LayoutOptions defaults;

CriticalPoints four_corners(const CadFace& face, int first_valence = 1) {
  CriticalPoints all;
  for (int j = 0; j < 4; ++j) all.corners.push_back({j, face.joints[j].position, 90, j == 0 ? first_valence : 1, {}});
  return all;
}

struct ConstantField : testing::Test {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  Report report;
};

TEST_F(ConstantField, ASquareIsOneBlock) {
  const graph::CandidateLayout layout = trace_separatrices(evaluator, four_corners(field.mesh.face), defaults, report);
  EXPECT_TRUE(layout.lines.empty());
  EXPECT_EQ(graph::require_four_corners(layout.subdivision), 1);
}

TEST_F(ConstantField, ADegenerateCornerIsNamedWithItsPlace) {
  field.mesh.face.origin = {100, 0};
  try {
    trace_separatrices(evaluator, four_corners(field.mesh.face, 0), defaults, report);
    FAIL();
  } catch (const ComputeError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("90.0 degrees"), std::string::npos) << message;
    EXPECT_NE(message.find("(99, -1)"), std::string::npos) << message;
    EXPECT_NE(message.find("--degenerate divide"), std::string::npos) << message;
  }
}

TEST_F(ConstantField, ZerosThatLaunchTooFewLinesAreRefused) {
  CriticalPoints points = four_corners(field.mesh.face);
  points.critical_points.push_back({{0, 0}, 4, 0, 0, {}, {}});
  EXPECT_THROW(trace::fixed_nodes(field.mesh.face, points), ComputeError);
}

TEST_F(ConstantField, OptionsAreChecked) {
  LayoutOptions options;
  options.trace.tolerance = 0;
  EXPECT_THROW(trace_separatrices(evaluator, four_corners(field.mesh.face), options, report), UsageError);
  LayoutOptions turning;
  turning.trace.merge_angle = -1;
  EXPECT_THROW(turning.validate(), UsageError);
}

TEST(TraceSeparatrices, FiveRaysOfOneNodeEndOnTheBoundary) {
  // v = conj z is no field of a square's boundary, but five straight rays it has; the faces have five and four corners.
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 5), 1, [](Vec2 p) { return Vec2{p.x, -p.y}; });
  const field::FieldEvaluator evaluator(field);
  CriticalPoints points = four_corners(field.mesh.face);
  points.critical_points.push_back({{0, 0}, -1, 5, 0, {}, {}});
  Report report;
  EXPECT_THROW(trace_separatrices(evaluator, points, defaults, report), ComputeError);
  const std::vector<trace::Launch> launches = trace::launch_all(evaluator, points);
  ASSERT_EQ(launches.size(), 5u);
  for (const trace::Launch& launch : launches) EXPECT_EQ(launch.start.node, 0);
}

TEST(TraceSeparatrices, SixRaysOfADoubleZero) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 5), 2, [](Vec2 p) {
    return Vec2{p.x * p.x - p.y * p.y, -2 * p.x * p.y};
  });
  const field::FieldEvaluator evaluator(field);
  const auto rays = trace::launch_directions_on_circle(evaluator, {0, 0}, 0.01, 6);
  ASSERT_EQ(rays.size(), 6u);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(wrap_pi(rays[k] - k * pi / 3), 0, 1e-9);
}

}  // namespace
}  // namespace quadrille::layout
