#include "field/node_phase.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "base/error.hpp"

namespace quadrille::field {
namespace {

// phi = arg(z - a) - arg(z - b) + s, s = 0.3 + 2 x.
Field phase_field(Vec2 a, Vec2 b) {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 2, [](Vec2 x) { return Vec2{0.3 + 2 * x.x, 0}; });
  field.kind = FieldKind::phase;
  field.phase.s = field.u;
  field.u.clear();
  field.v.clear();
  field.phase.prescribed.nodes = {{a, 3}, {b, 5}};
  field.phase.terms.nodes = {{a, 1}, {b, -1}};
  return field;
}

TEST(NodePhase, IsThePhaseWithoutTheNodesOwnTerm) {
  const Vec2 a{0.25, 0.4}, b{0.75, 0.9};
  const Field field = phase_field(a, b);
  const FieldEvaluator evaluator(field);
  EXPECT_NEAR(wrap_pi(node_phase(evaluator, 0) - (0.3 + 2 * a.x - angle_of(a - b))), 0, 1e-13);
  EXPECT_NEAR(wrap_pi(node_phase(evaluator, 1) - (0.3 + 2 * b.x + angle_of(b - a))), 0, 1e-13);
}

TEST(NodePhase, RefusesNodesOutsideTheMesh) {
  const Field field = phase_field({1.5, 0.5}, {0.5, 0.5});
  const FieldEvaluator evaluator(field);
  EXPECT_THROW(node_phase(evaluator, 0), FormatError);
}

}  // namespace
}  // namespace quadrille::field
