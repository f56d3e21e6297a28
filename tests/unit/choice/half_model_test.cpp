#include "choice/half_model.hpp"

#include <gtest/gtest.h>

#include "../support/polygon_field.hpp"
#include "../triangulate/faces.hpp"
#include "check/check.hpp"
#include "choice/choose_nodes.hpp"
#include "field/evaluate.hpp"

namespace quadrille::choice {
namespace {

using namespace testing_faces;

/// The upper half of a rectangle around a disc; its last curve ends at the left end of the line.
CadFace half_box() {
  Loop loop{curve::segment({-4, 0}, {-1, 0}), curve::circular_arc({0, 0}, 1, pi, 0), curve::segment({1, 0}, {5, 0})};
  const std::vector<Vec2> corners{{5, 0}, {5, 3}, {-4, 3}, {-4, 0}};
  for (std::size_t i = 0; i < 3; ++i) loop.push_back(curve::segment(corners[i], corners[i + 1]));
  CadFace face = make_face({loop});
  face.curve_names = {"symmetry", "body", "symmetry", "outer", "outer", "outer"};
  return face;
}

NodeOptions at_symmetry() {
  NodeOptions options;
  options.symmetry = {"symmetry"};
  return options;
}

/// The nodes above the x axis.
std::vector<CriticalPoint> upper(const CriticalPoints& points) {
  std::vector<CriticalPoint> nodes = points.critical_points;
  std::erase_if(nodes, [](const CriticalPoint& node) { return node.position.y < 0; });
  return nodes;
}

void expect_half(const NodeOptions& half_options, const NodeOptions& whole_options) {
  const Field half = adapted_field(half_box()), whole = adapted_field(curve::whole_of(half_box(), {"symmetry"}));
  Report report;
  const CriticalPoints points = choose_nodes(half, half_options, 1, report);
  EXPECT_TRUE(report.warnings().empty());
  EXPECT_EQ(points.form, NodeForm::phase);
  for (const check::Violation& v : check::check_stage(points, check::CheckDepth::full)) ADD_FAILURE() << v.text;
  for (const check::Violation& v : check::check_critical_points_of(points, half.mesh)) ADD_FAILURE() << v.text;
  const std::vector<CriticalPoint> expected = upper(choose_nodes(whole, whole_options, 1, report));
  ASSERT_EQ(points.critical_points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(points.critical_points[i].valence, expected[i].valence);
    EXPECT_NEAR(distance(points.critical_points[i].position, expected[i].position), 0, 1e-6);
  }
}

TEST(HalfModel, TheNodesAreThoseOfTheWhole) { expect_half(at_symmetry(), {}); }

TEST(HalfModel, TheScaleOfTheWholeIsThatOfTheHalfAndItsImage) {
  NodeOptions options = at_symmetry();
  options.placement.log_scale = [](Vec2 x, Vec2& gradient) {
    gradient = {1, 2 * x.y};
    return x.x + x.y * x.y * (x.y < 0 ? -1 : 1);  // another one below
  };
  Field half;
  half.mesh.face = half_box();
  const auto lines =
      curve::symmetry_lines(half.mesh.face, curve::curves_that_fit(half.mesh.face, options.symmetry)).lines;
  const NodeOptions whole = HalfModel(half, options, lines.front()).options_of_whole();
  Vec2 above, below;
  EXPECT_NEAR(whole.placement.log_scale({2, 1.5}, above), 4.25, 1e-14);
  EXPECT_NEAR(whole.placement.log_scale({2, -1.5}, below), 4.25, 1e-14);
  EXPECT_NEAR(distance(above, {1, 3}), 0, 1e-14);
  EXPECT_NEAR(distance(below, {1, -3}), 0, 1e-14);
}

TEST(HalfModel, KindsOfGridAndPlacedNodesAreThoseOfTheWhole) {
  NodeOptions half = at_symmetry(), whole;
  for (NodeOptions* options : {&half, &whole}) options->topology = topology::GridKind::h;
  expect_half(half, whole);
}

TEST(HalfModel, TheWholeIsAlignedOnBothSides) {
  Field half = adapted_field(half_box());
  half.alignment = {{{2, 1.5}, 0.5, 20, 0.3}};
  const curve::SymmetryLine line =
      curve::symmetry_lines(half.mesh.face, curve::curves_that_fit(half.mesh.face, {"symmetry"})).lines.front();
  const Field whole = HalfModel(half, at_symmetry(), line).field_of_whole(1);
  const field::FieldEvaluator evaluator(whole);
  Vec2 above, below;
  ASSERT_TRUE(evaluator.value_at({2, 1.5}, above) && evaluator.value_at({2, -1.5}, below));
  EXPECT_NEAR(distance(below, {above.x, -above.y}), 0, 1e-9);
  EXPECT_GT(above.y, 0.1);
}

TEST(HalfModel, PrescribedValencesHoldForTheImageToo) {
  NodeOptions half = at_symmetry(), whole;
  half.overrides = {{3, 4, 2}};  // the upper right corner
  whole.overrides = {{0, 1, 2}, {4, 5, 2}};
  expect_half(half, whole);
}

TEST(HalfModel, WhereTheWholeHasANodeOfOddValenceOnTheLineTheHalfHasItsOwn) {
  CadFace face = make_face({polygon({{-1, 0}, {std::sqrt(3.0) - 1, 0}, {-1, 1}})});  // of an equilateral triangle
  face.curve_names = {"symmetry", "side", "side"};
  Report report;
  const CriticalPoints points = choose_nodes(adapted_field(face), at_symmetry(), 1, report);
  EXPECT_TRUE(report.warnings().empty());
  ASSERT_EQ(points.critical_points.size(), 1U);
  EXPECT_EQ(points.critical_points[0].valence, 3);
  EXPECT_EQ(points.index_sum, 4);
}

}  // namespace
}  // namespace quadrille::choice
