#include "field/check_nodes_match_field.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../support/phase_field.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::field {
namespace {

// v = (x + i y - a)(...): one zero of index +1 at (0.25, 0.125) in a square whose corners make up for it.
struct OneZero : testing::Test {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 1, [](Vec2 p) {
    return Vec2{p.x - 0.25, p.y - 0.125};
  });
  FieldEvaluator evaluator{field};

  CriticalPoints points() const {
    CriticalPoints all;
    all.critical_points.push_back({{0.25, 0.125}, 1, 3, 0, {}, {}});
    // 1 + 4 - 1 = 4 chi: one corner counts 2.
    for (int j = 0; j < 4; ++j) all.corners.push_back({j, field.mesh.face.joints[j].position, 90, j == 0 ? 2 : 1, {}});
    return all;
  }
};

TEST_F(OneZero, AcceptsTheFieldsOwnZeros) { EXPECT_NO_THROW(check_nodes_match_field(evaluator, points())); }

TEST_F(OneZero, AcceptsAnErrorBelowAMillionthOfTheDiameter) {
  CriticalPoints p = points();
  p.critical_points[0].position.x += 0.9e-6 * field.mesh.face.diameter;
  EXPECT_NO_THROW(check_nodes_match_field(evaluator, p));
  p.critical_points[0].position.x += 0.2e-6 * field.mesh.face.diameter;
  EXPECT_THROW(check_nodes_match_field(evaluator, p), FormatError);
}

TEST_F(OneZero, RefusesAnotherIndexOrPlace) {
  CriticalPoints p = points();
  p.critical_points[0].index = -1, p.critical_points[0].valence = 5;
  EXPECT_THROW(check_nodes_match_field(evaluator, p), FormatError);
  p = points();
  p.critical_points[0].position = {3, 3};
  EXPECT_THROW(check_nodes_match_field(evaluator, p), FormatError);
}

TEST_F(OneZero, RefusesAWrongIndexSum) {
  CriticalPoints p = points();
  p.critical_points.clear();
  EXPECT_THROW(check_nodes_match_field(evaluator, p), FormatError);
  p = points();
  p.corners[1].valence = 2;
  EXPECT_THROW(check_nodes_match_field(evaluator, p), FormatError);
}

std::string refusal(const FieldEvaluator& evaluator, const CriticalPoints& points) {
  return message_of<FormatError>([&] { check_nodes_match_field(evaluator, points); });
}

TEST_F(OneZero, RefusesTheFormPhaseAndNodesOnTheBoundary) {
  CriticalPoints p = points();
  p.form = NodeForm::phase;
  EXPECT_NE(refusal(evaluator, p).find("which is harmonic: run fieldsolve --nodes"), std::string::npos);
  p = points();
  p.boundary_nodes.push_back({0, 1, {0, -1}, 3, NodeSource::feature});
  p.corners[0].valence = 1;
  EXPECT_NE(refusal(evaluator, p).find("run fieldsolve --nodes"), std::string::npos);
}

// A square with a node of valence 3 inside and one on its lower side; the corners have 1, as the index sum wants.
struct AskedPhase : testing::Test {
  Field field = make_field();
  FieldEvaluator evaluator{field};

  static Field make_field() {
    Field made = closed_phase(square_mesh({-1, -1}, 2, 3), {{{{0.25, 0.125}, 1}}, {}, {}, {}}, 0);
    for (int j = 0; j < 4; ++j) made.phase.prescribed.corners.push_back({j, 1});
    made.phase.prescribed.boundary_nodes.push_back({0, 1, 3});
    return made;
  }
  CriticalPoints points() const {
    CriticalPoints all;
    all.form = NodeForm::phase;
    all.critical_points.push_back({{0.25, 0.125}, 1, 3, 0, {}, {}});
    for (int j = 0; j < 4; ++j) all.corners.push_back({j, field.mesh.face.joints[j].position, 90, 1, {}});
    all.boundary_nodes.push_back({0, 1, {0, -1}, 3, NodeSource::feature});
    return all;
  }
  void expect_refused(const CriticalPoints& p) const {
    EXPECT_NE(refusal(evaluator, p).find("run fieldsolve --nodes"), std::string::npos);
  }
};

TEST_F(AskedPhase, AcceptsWhatTheFieldWasAskedFor) {
  CriticalPoints p = points();
  EXPECT_EQ(refusal(evaluator, p), "");
  p.form = NodeForm::harmonic;  // the nodes decide, not the word
  EXPECT_EQ(refusal(evaluator, p), "");
}

TEST_F(AskedPhase, RefusesNodesMovedByMoreThanABillionthOfTheDiameter) {
  CriticalPoints p = points();
  p.critical_points[0].position.x += 0.9e-9 * field.mesh.face.diameter;
  p.boundary_nodes[0].t += 0.9e-9 * field.mesh.face.diameter;
  EXPECT_EQ(refusal(evaluator, p), "");
  CriticalPoints inside = p, outer = p;
  inside.critical_points[0].position.x += 0.2e-9 * field.mesh.face.diameter;
  expect_refused(inside);
  outer.boundary_nodes[0].t += 0.2e-9 * field.mesh.face.diameter;
  expect_refused(outer);
}

TEST_F(AskedPhase, RefusesOtherValencesAndNumbers) {
  CriticalPoints p = points();
  p.corners[1].valence = 2;
  expect_refused(p);
  p = points();
  p.boundary_nodes.clear();
  expect_refused(p);
  p = points();
  p.critical_points.push_back({{-0.5, 0}, 1, 3, 0, {}, {}});
  expect_refused(p);
  p = points();
  p.critical_points[0].index = -1, p.critical_points[0].valence = 5;
  expect_refused(p);
}

TEST_F(AskedPhase, NoHoleWindingOffsetsAreOffsetsOfZero) {
  field.phase.hole_winding_offsets = {0};
  EXPECT_EQ(refusal(evaluator, points()), "");
}

}  // namespace
}  // namespace quadrille::field
