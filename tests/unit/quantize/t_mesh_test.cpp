#include "quantize/t_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/square_field.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "trace/advance.hpp"
#include "trace/launch_all.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::quantize {
namespace {

Nurbs hole(Vec2 centre, double radius, double first_angle) {
  Nurbs circle = curve::circular_arc({0, 0}, radius, first_angle + 2 * pi, first_angle);
  for (Vec2& pole : circle.poles) pole += centre;
  return circle;
}

/// The square [-1, 1]^2 with round holes, and a field given in closed form.
struct Holes {
  Field field;
  field::FieldEvaluator evaluator;
  CriticalPoints points;

  Holes(const std::vector<Nurbs>& circles, const std::function<Vec2(Vec2)>& value)
      : field(interpolated_field(mesh(circles), 10, value)), evaluator(field) {
    for (int j = 0; j < 4; ++j) points.corners.push_back({j, field.mesh.face.joints[j].position, 90, 1, {}});
  }

  static TriMesh mesh(const std::vector<Nurbs>& circles) {
    std::vector<std::vector<Nurbs>> loops{{curve::segment({-1, -1}, {1, -1}), curve::segment({1, -1}, {1, 1}),
                                           curve::segment({1, 1}, {-1, 1}), curve::segment({-1, 1}, {-1, -1})}};
    for (const Nurbs& circle : circles) loops.push_back({circle});
    Report report;
    return triangulate::triangulate(hand_made::face(loops, std::sqrt(8.0)), {}, report);
  }
};

// Crosses along the axes: no line starts anywhere.
Vec2 constant(Vec2) { return {1, 0}; }

TEST(TMesh, AHoleThatNoLineReachesIsTiedToTheRest) {
  // With two holes: one alone in a face without launches is cut otherwise.
  const Holes holes({hole({-0.4, 0.3}, 0.1, 0), hole({0.5, -0.4}, 0.1, 0)}, constant);
  Report report;
  const graph::CandidateLayout t_mesh = TMeshTracer(holes.evaluator, holes.points, {}).trace(report);
  ASSERT_EQ(t_mesh.lines.size(), 2u);
  EXPECT_EQ(t_mesh.subdivision.num_components(), 1);
  for (const SeparatrixLine& line : t_mesh.lines) {
    EXPECT_EQ(line.kind, LineKind::cut);
    // From the middle of the circle, half a turn from its start, straight to the left side.
    EXPECT_NEAR(t_mesh.graph().nodes[line.end].position.x, -1, 1e-9);
    EXPECT_NEAR(t_mesh.graph().nodes[line.end].position.y, t_mesh.graph().nodes[line.origin].position.y, 1e-9);
  }
}

TEST(TMesh, HolesThatTieEachOtherAreTiedToTheOuterBoundaryToo) {
  // Cut from the middle of its curve each hole meets the other.
  const Holes holes({hole({-0.5, 0}, 0.1, pi), hole({0.5, 0}, 0.1, 0)}, constant);
  Report report;
  const graph::CandidateLayout t_mesh = TMeshTracer(holes.evaluator, holes.points, {}).trace(report);
  EXPECT_EQ(t_mesh.subdivision.num_components(), 1);
  EXPECT_LT(t_mesh.lines.size(), 10u);
}

/// Lines that enter the square at a corner towards the centre turn away from it, and for ever round the circle of
/// radius 1/2.
struct Spiral : Holes {
  static constexpr double radius = 0.5;
  explicit Spiral(double sense)
      : Holes({hole({0, 0}, 0.2, 0)}, [sense](Vec2 p) {
          const double tilt = half_pi * (1 - (norm(p) - radius) / (std::sqrt(2.0) - radius));
          return unit(4 * (angle_of(p) + sense * tilt));
        }) {
    points.corners[0].valence = 2;
  }
};

// True for both senses of rotation: one side of the cycle leads to the outer boundary, the other to the hole.
TEST(TMesh, ALimitCycleThatMeetsNobodyIsCutAcross) {
  for (const double sense : {1.0, -1.0}) {
    const Spiral spiral(sense);
    Report report;
    const graph::CandidateLayout t_mesh = TMeshTracer(spiral.evaluator, spiral.points, {}).trace(report);
    ASSERT_EQ(t_mesh.lines.size(), 2u);
    EXPECT_EQ(t_mesh.lines[0].kind, LineKind::traced);
    EXPECT_EQ(t_mesh.lines[1].kind, LineKind::cut);
    // The line ends where it meets the cut, which leads from boundary to boundary.
    ASSERT_EQ(t_mesh.t_junctions.size(), 1u);
    EXPECT_EQ(t_mesh.lines[0].end, t_mesh.t_junctions[0]);
    EXPECT_NE(spiral.field.mesh.face.loop_of(t_mesh.graph().nodes[t_mesh.lines[1].origin].curve),
              spiral.field.mesh.face.loop_of(t_mesh.graph().nodes[t_mesh.lines[1].end].curve));
    EXPECT_EQ(t_mesh.subdivision.num_components(), 1);
  }
}

TEST(TMesh, ALineWithoutEndWhoseStepsAreTooShortIsRefused) {
  const Spiral spiral(1);
  trace::TraceOptions options;
  options.step = 1e-6;
  Report report;
  try {
    TMeshTracer(spiral.evaluator, spiral.points, options).trace(report);
    FAIL() << "it was traced";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("steps, the most allowed, take the separatrix"), std::string::npos);
  }
}

TEST(TMesh, ASpiralIsNotFollowedRoundItsLimitCycle) {
  const Spiral spiral(1);
  const double d = spiral.field.mesh.face.diameter;
  const trace::AdvanceOptions options{1e-10 * d, d / 20, 100 * d, 1e-7 * d};
  const std::vector<trace::Launch> launches = trace::launch_all(spiral.evaluator, spiral.points);
  ASSERT_EQ(launches.size(), 1u);
  trace::Streamline line = trace::advance(spiral.evaluator, launches[0], PointGrid({}), options);
  EXPECT_TRUE(line.is_limit_cycle);
  EXPECT_EQ(line.end, trace::Streamline::End::length);
  EXPECT_NEAR(norm(line.end_position), Spiral::radius, 1e-6);
  EXPECT_LT(line.length(), 20 * d);
  const size_t num_steps = line.steps.size();
  trace::follow(spiral.evaluator, line, PointGrid({}), options);
  EXPECT_EQ(line.steps.size(), num_steps);
}

}  // namespace
}  // namespace quadrille::quantize
