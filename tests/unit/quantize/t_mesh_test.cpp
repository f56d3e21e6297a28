#include "quantize/t_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../hand_made.hpp"
#include "../support/square_field.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "trace/advance.hpp"
#include "trace/launch.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::quantize {
namespace {

std::vector<Nurbs> rectangle(Vec2 low, Vec2 high) {
  const std::vector<Vec2> p{low, {high.x, low.y}, high, {low.x, high.y}};
  return {curve::segment(p[0], p[1]), curve::segment(p[1], p[2]), curve::segment(p[2], p[3]),
          curve::segment(p[3], p[0])};
}

// A square with two square holes, their curves 4 to 7 and 8 to 11.
CadFace face_with_holes() {
  return hand_made::face({rectangle({0, 0}, {10, 10}), rectangle({1, 1}, {2, 2}), rectangle({5, 5}, {6, 6})}, 14);
}

GraphNode on_curve(int curve) { return {{}, NodeKind::boundary, 2, curve, 0}; }

TEST(UnconnectedLoops, AreThoseThatNoArcsReach) {
  SeparatrixGraph graph;
  graph.face = face_with_holes();
  graph.nodes = {on_curve(0), on_curve(4), on_curve(8)};
  EXPECT_EQ(unconnected_loops(graph), (std::vector<int>{1, 2}));
  graph.arcs = {{1, 2, false, 0, {}}};  // the holes to each other
  EXPECT_EQ(unconnected_loops(graph), (std::vector<int>{1, 2}));
  graph.arcs.push_back({2, 0, false, 0, {}});
  EXPECT_TRUE(unconnected_loops(graph).empty());
}

TEST(CutFromLoop, StartsAtTheMiddleOfTheFirstCurveThenElsewhere) {
  const CadFace face = face_with_holes();
  const CutStart first = cut_from_loop(face, 1, 0);
  EXPECT_EQ(first.curve, 4);
  EXPECT_NEAR(first.t, (face.curves[4].begin() + face.curves[4].end()) / 2, 1e-15);
  // Half a loop farther, then a quarter and three quarters.
  EXPECT_EQ(cut_from_loop(face, 1, 1).curve, 6);
  EXPECT_EQ(cut_from_loop(face, 1, 2).curve, 5);
  EXPECT_EQ(cut_from_loop(face, 1, 3).curve, 7);
  EXPECT_EQ(cut_from_loop(face, 2, 1).curve, 10);
}

TEST(CutFromLoop, NeverStartsTwiceAtOnePoint) {
  const CadFace face = face_with_holes();
  for (int a = 0; a < 32; ++a)
    for (int b = 0; b < a; ++b) {
      const CutStart p = cut_from_loop(face, 2, a), q = cut_from_loop(face, 2, b);
      EXPECT_FALSE(p.curve == q.curve && p.t == q.t) << a << " " << b;
    }
}

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

/// What the tracer says that cannot follow the lines of this field.
std::string refusal(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                    const trace::TraceOptions& options) {
  Report report;
  try {
    TMeshTracer(evaluator, points, options).trace(report);
  } catch (const ComputeError& error) {
    return error.what();
  }
  return "";
}

TEST(TMesh, ALineWithoutEndWhoseStepsAreTooShortIsRefused) {
  const Spiral spiral(1);
  trace::TraceOptions options;
  options.step = 1e-6;
  EXPECT_NE(refusal(spiral.evaluator, spiral.points, options).find("steps take the separatrix"), std::string::npos);
}

TEST(TMesh, ALineThatGetsNoLongerIsRefused) {
  // Below y = -1/2 lines rise at 20 degrees, above they fall: none can cross, nor turn back.
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 4), 1, constant);
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    const Vec2 turned = unit(4 * radians(e < 8 ? 20 : -20));
    for (int i = field.coef_offsets[e]; i < field.coef_offsets[e + 1]; ++i) {
      field.v[i] = field.u[i] * turned.y;
      field.u[i] *= turned.x;
    }
  }
  CriticalPoints points;
  for (int j = 0; j < 4; ++j) points.corners.push_back({j, field.mesh.face.joints[j].position, 90, j == 0 ? 2 : 1, {}});
  const std::string said = refusal(field::FieldEvaluator(field), points, {});
  EXPECT_NE(said.find("the separatrix from (-1, -1) no farther than 0.517 diameters, to (0.3737"), std::string::npos)
      << said;
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
