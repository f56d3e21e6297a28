#include "trace/launch.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/phase_field.hpp"
#include "../support/square_field.hpp"
#include "../support/texts.hpp"
#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "field/evaluate.hpp"
#include "field/explicit_value.hpp"
#include "trace/launch_directions.hpp"

// Launching from phases with closed forms (lib/method.md §8.7).

namespace quadrille::trace {
namespace {

using namespace testing_faces;

CriticalPoint node(Vec2 x, int valence) { return {x, 4 - valence, valence, 0, {}, {}}; }

/// The lower side of the square is cut in two at a smooth joint, (0.5, 0): curves 0 and 1.
CadFace square_with_joint() {
  CadFace face = make_face({polygon({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}})});
  face.origin = {10, 20};
  return face;
}

std::string refusal(const CriticalPoints& points) {
  return message_of<ComputeError>([&] { fixed_nodes(square_with_joint(), points); });
}

TEST(FixedNodes, AreInnerOnesThenCornersThenThoseOnTheBoundary) {
  CriticalPoints points;
  points.boundary_nodes.push_back({3, 0.25, {0.75, 1}, 3, NodeSource::feature});
  points.corners.push_back({2, {1, 0}, 90, 1, {}});
  points.critical_points = {node({0.3, 0.4}, 3), node({0.6, 0.4}, 5)};
  const std::vector<GraphNode> nodes = fixed_nodes(square_with_joint(), points);
  ASSERT_EQ(nodes.size(), 4u);
  EXPECT_EQ(nodes[0].kind, NodeKind::irregular);
  EXPECT_EQ(nodes[1].valence, 5);
  EXPECT_EQ(nodes[1].curve, -1);
  EXPECT_EQ(nodes[2].kind, NodeKind::corner);
  EXPECT_EQ(nodes[2].curve, 2);
  EXPECT_EQ(nodes[2].t, square_with_joint().curves[2].begin());
  EXPECT_EQ(nodes[3].kind, NodeKind::boundary);
  EXPECT_EQ(nodes[3].curve, 3);
  EXPECT_EQ(nodes[3].t, 0.25);
  EXPECT_EQ(positions(nodes), (std::vector<Vec2>{{0.3, 0.4}, {0.6, 0.4}, {1, 0}, {0.75, 1}}));
}

TEST(FixedNodes, ABoundaryNodeAtTheEndOfACurveIsItsJoint) {
  for (const auto& [curve, t] : {std::pair{0, 0.5}, {1, 0.0}, {1, 1e-14}}) {
    CriticalPoints points;
    points.boundary_nodes.push_back({curve, t, {}, 3, NodeSource::feature});
    const GraphNode found = fixed_nodes(square_with_joint(), points).at(0);
    EXPECT_EQ(found.curve, 1) << curve;
    EXPECT_EQ(found.t, square_with_joint().curves[1].begin()) << curve;
    EXPECT_EQ(found.position, (Vec2{0.5, 0}));
  }
}

TEST(FixedNodes, TheLastCurveOfALoopEndsAtItsFirstJoint) {
  CriticalPoints points;
  points.boundary_nodes.push_back({4, 1, {}, 3, NodeSource::feature});
  const GraphNode found = fixed_nodes(square_with_joint(), points).at(0);
  EXPECT_EQ(found.curve, 0);
  EXPECT_EQ(found.t, square_with_joint().curves[0].begin());
}

TEST(FixedNodes, NodesThatNoLayoutCanHaveAreRefusedWithTheirPlace) {
  CriticalPoints zero, corner, straight;
  zero.critical_points = {node({0.3, 0.4}, 2)};
  EXPECT_TRUE(contains(refusal(zero), "(10.3, 20.4) has index +2")) << refusal(zero);
  corner.corners.push_back({2, {1, 0}, 20, 0, {}});
  EXPECT_TRUE(contains(refusal(corner), "20.0 degrees at (11, 20)")) << refusal(corner);
  EXPECT_TRUE(contains(refusal(corner), "--degenerate divide"));
  straight.boundary_nodes.push_back({3, 0.25, {}, 1, NodeSource::feature});
  EXPECT_TRUE(contains(refusal(straight), "valence 1 on the smooth boundary at (10.75, 21)")) << refusal(straight);
}

TEST(FixedNodes, TheLeastValencesAreKept) {
  CriticalPoints points;
  points.critical_points = {node({0.3, 0.4}, 3)};
  points.corners.push_back({2, {1, 0}, 90, 1, {}});
  points.boundary_nodes.push_back({3, 0.25, {}, 3, NodeSource::feature});
  EXPECT_EQ(refusal(points), "");
}

TEST(LaunchLine, FollowsACurvedSeparatrixToThirdOrder) {
  // v = z (1 + c z): the separatrix along the axis bends away with c's imaginary part.
  const auto value = [](Vec2 p) {
    const Vec2 c{0, 0.3}, w{1 + c.x * p.x - c.y * p.y, c.x * p.y + c.y * p.x};
    return Vec2{p.x * w.x - p.y * w.y, p.x * w.y + p.y * w.x};
  };
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 2, value);
  const field::FieldEvaluator evaluator(field);
  // Near 0 the separatrix is y = kappa x^2 / 2 with 4 y' = y / x + 0.3 x, so kappa = 0.3 / 3.5.
  const double kappa = 0.3 / 3.5;
  for (const double r : {1e-2, 1e-3}) {
    const Launch launch = launch_line(evaluator, 0, {0, 0}, 0, r, 1);
    EXPECT_NEAR(launch.x.y, kappa * r * r / 2, r * r * r);
    EXPECT_NEAR(launch.angle_there, kappa * r, r * r);
    EXPECT_NEAR(norm(launch.x), r, 1e-14);
  }
}

TEST(LaunchLine, RefusesADirectionOutOfTheDomain) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator evaluator(field);
  EXPECT_THROW(launch_line(evaluator, 0, {0, 0}, -1, 1e-3, 1), ComputeError);
}

using Complex = std::complex<double>;

Complex complex(Vec2 a) { return {a.x, a.y}; }

const std::vector<Vec2> scattered{{0.3, 0.2}, {-0.4, 0.35}, {-0.25, -0.5}, {0.45, -0.3}};

CriticalPoints points_of(const Field& field) {
  CriticalPoints points;
  points.form = NodeForm::phase;
  for (const PhaseNode& node : field.phase.prescribed.nodes)
    points.critical_points.push_back({node.position, 4 - node.valence, node.valence, 0, {}, {}});
  return points;
}

TEST(NodePhase, IsTheClosedFormWithoutTheNodesOwnTurn) {
  const Field field = disc_phase(scattered);
  const field::FieldEvaluator evaluator(field);
  for (int k = 0; k < 4; ++k) {
    const Complex a = complex(scattered[k]);
    Complex product = 1;
    for (int j = 0; j < 4; ++j) {
      const Complex b = complex(scattered[j]);
      product *= (j == k ? 1.0 : a - b) * (1.0 - std::conj(b) * a);
    }
    EXPECT_NEAR(wrap_pi(field::node_phase(evaluator, k) - std::arg(product)), 0, 1e-13);
  }
}

TEST(PhaseLaunch, ASquareOfNodesInADiscLaunchesOutwardsAndToItsNeighbours) {
  std::vector<Vec2> square;
  for (int k = 0; k < 4; ++k) square.push_back(0.6 * unit(pi / 4 + k * half_pi));
  const Field field = disc_phase(square);
  const field::FieldEvaluator evaluator(field);
  const std::vector<Launch> launches = launch_all(evaluator, points_of(field));
  ASSERT_EQ(launches.size(), 12u);
  for (const Launch& launch : launches) {
    const double from_outwards = launch.angle - angle_of(launch.origin);
    EXPECT_NEAR(wrap_pi(3 * from_outwards), 0, 1e-13);
    EXPECT_LT(launch.radius, 1e-3);
  }
}

TEST(PhaseLaunch, ANodeOfValenceSixLaunchesSixLines) {
  // arg of conj(z)^2, turned by 0.5.
  const Field field = closed_phase(square_mesh({-1, -1}, 2, 3), {{{{0.1, 0.2}, -2}}, {}, {}, {}}, 0.5);
  const field::FieldEvaluator evaluator(field);
  const std::vector<Launch> launches = launch_all(evaluator, points_of(field));
  ASSERT_EQ(launches.size(), 6u);
  for (const Launch& launch : launches) {
    EXPECT_NEAR(wrap_pi(6 * launch.angle - 0.5), 0, 1e-13);
    // The field of a single node has straight separatrices.
    EXPECT_NEAR(wrap_pi(launch.angle_there - launch.angle), 0, 1e-11);
  }
}

TEST(PhaseLaunch, BendsLinearlyWithTheSlopeOfTheOtherTerms) {
  // 4 direction = phi_0 + d bearing + g . e r and direction = angle + 2 beta, bearing = angle + beta: beta = g . e r /
  // (8 - d).
  const Field field = disc_phase(scattered);
  const field::FieldEvaluator evaluator(field);
  PhaseTerms others = field.phase.terms;
  others.nodes.erase(others.nodes.begin());
  const Vec2 slope = field::explicit_phase_gradient(others, scattered[0]);
  for (const double angle : phase_launch_directions(field::node_phase(evaluator, 0), 3)) {
    const double beta = dot(slope, unit(angle)) / 7;
    for (const double r : {1e-2, 1e-3}) {
      const Launch launch = launch_line(evaluator, 0, scattered[0], angle, r, 1);
      EXPECT_NEAR(wrap_pi(angle_of(launch.x - scattered[0]) - angle), beta * r, 3 * r * r);
      EXPECT_NEAR(wrap_pi(launch.angle_there - angle), 2 * beta * r, 3 * r * r);
    }
  }
}

// A node of valence 3 in the middle of the square's lower side: beta = 4 - 2 V = -2.
Field field_with_boundary_node() {
  const Vec2 apex{0, -1}, pole{0, -3};
  Field field = closed_phase(square_mesh({-1, -1}, 2, 3), {{}, {}, {}, {{apex, pole, -2}}}, 0);
  // The cross is along the side: phi = 0 on the way out of the apex, to the right.
  const double there = -2 * field::corner_angle(field.phase.terms.corner_angles[0], apex, {1, 0});
  return closed_phase(std::move(field.mesh), field.phase.terms, -there);
}

// v = conj((z^2 - w) (z^2 - conj(w))) is along both sides at the corner 0 of the unit square, which has V = 1, and has
// a zero of index -1 at z = sqrt(w).
Field field_with_zero_near_corner(Complex w) {
  return interpolated_field(square_mesh({0, 0}, 1, 2), 4, [w](Vec2 x) {
    const Complex square = complex(x) * complex(x), v = std::conj((square - w) * (square - std::conj(w)));
    return Vec2{v.real(), v.imag()};
  });
}

TEST(LaunchAll, ACornerThatAbsorbedAZeroLaunchesBeyondTheZero) {
  const Complex zero = std::polar(0.02, 0.6);
  const Field field = field_with_zero_near_corner(zero * zero);
  const field::FieldEvaluator evaluator(field);
  CriticalPoints points;
  points.corners.push_back({0, {0, 0}, 90, 2, {3, 0}, NodeSource::absorb});
  points.changes.push_back({ChangeKind::absorb,
                            "near",
                            {{{0, 0}, 1, NodeLocation::corner}, {{zero.real(), zero.imag()}, 5, NodeLocation::inside}},
                            {{{0, 0}, 2, NodeLocation::corner}}});
  const std::vector<Launch> launches = launch_all(evaluator, points);
  ASSERT_EQ(launches.size(), 1u);
  EXPECT_NEAR(launches[0].radius, 2 * std::abs(zero), 1e-15);
  EXPECT_NEAR(angle_of(launches[0].x), launches[0].angle, 1e-9) << "straight from the corner";
  Vec2 value;
  ASSERT_TRUE(evaluator.value_at(launches[0].x, value));
  EXPECT_NEAR(wrap_pi(4 * launches[0].angle - angle_of(value)), 0, 1e-9) << "along the field";
  EXPECT_NEAR(wrap_pi(launches[0].angle_there - launches[0].angle), 0, 1e-9);
}

TEST(LaunchAll, DirectionsOnAnArcAreThoseOfTheCornerWithItsZero) {
  // On an arc far beyond a zero of index -1 at 0.6 rad, the corner and the zero are like z^4: one line on the bisector.
  const Field field = field_with_zero_near_corner(std::polar(1e-4, 1.2));
  const std::vector<double> rays = launch_directions_on_arc(field::FieldEvaluator(field), {0, 0}, 0, half_pi, 0.5, 2);
  ASSERT_EQ(rays.size(), 1u);
  EXPECT_NEAR(rays[0], pi / 4, 1e-3);
}

TEST(PhaseLaunch, ABoundaryNodeDividesTheHalfPlane) {
  const Field field = field_with_boundary_node();
  const field::FieldEvaluator evaluator(field);
  CriticalPoints points;
  points.form = NodeForm::phase;
  points.boundary_nodes.push_back({0, 1, {0, -1}, 3, NodeSource::feature});
  const std::vector<Launch> launches = launch_all(evaluator, points);
  ASSERT_EQ(launches.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    const double angle = (k + 1) * pi / 3;
    EXPECT_NEAR(launches[k].angle, angle, 1e-14);
    // beta = g . e r / (8 - (4 - 2 V)), g = 2 d arg(z - p) at the apex = (-1, 0).
    const double beta = -std::cos(angle) / 10, r = launches[k].radius;
    EXPECT_NEAR(wrap_pi(angle_of(launches[k].x - Vec2{0, -1}) - angle), beta * r, 3 * r * r);
  }
}

TEST(PhaseLaunch, CornersDivideTheirAngle) {
  const std::vector<double> rays = phase_corner_launch_directions(radians(258), 3);
  ASSERT_EQ(rays.size(), 2u);
  EXPECT_NEAR(rays[0], radians(86), 1e-15);
  EXPECT_NEAR(rays[1], radians(172), 1e-15);
  EXPECT_TRUE(phase_corner_launch_directions(half_pi, 1).empty());
}

TEST(FixedNodes, BoundaryNodesComeLastAndAtJointsWithTheirJoint) {
  const CadFace face = square_face({0, 0}, 1);
  CriticalPoints points;
  points.boundary_nodes = {{1, 0.25, {1, 0.25}, 3, NodeSource::feature}, {1, 1, {1, 1}, 3, NodeSource::feature}};
  const std::vector<GraphNode> nodes = fixed_nodes(face, points);
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(nodes[0].kind, NodeKind::boundary);
  EXPECT_EQ(nodes[0].t, 0.25);
  EXPECT_EQ(nodes[0].position, (Vec2{1, 0.25}));
  EXPECT_EQ(nodes[1].curve, 2);
  EXPECT_EQ(nodes[1].t, face.curves[2].begin());
  EXPECT_EQ(nodes[1].position, (Vec2{1, 1}));
}

TEST(FixedNodes, AStraightCornerOfABlockIsRefused) {
  CriticalPoints points;
  points.boundary_nodes.push_back({0, 0.5, {0.5, 0}, 1, NodeSource::feature});
  EXPECT_THROW(fixed_nodes(square_face({0, 0}, 1), points), ComputeError);
}

}  // namespace
}  // namespace quadrille::trace
