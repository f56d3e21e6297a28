#include "ties/choice_cost.hpp"

#include <gtest/gtest.h>

#include "../support/polygon_field.hpp"
#include "plates.hpp"

namespace quadrille::ties {
namespace {

Cost cost(std::initializer_list<std::pair<Criterion, double>> entries) {
  Cost result{};
  for (const auto& [criterion, value] : entries) result[static_cast<std::size_t>(criterion)] = value;
  return result;
}

CriticalPoint node(Vec2 x, int index) {
  CriticalPoint p;
  p.position = x;
  p.index = index;
  p.valence = 4 - index;
  return p;
}

double figure(const Cost& c, Criterion criterion) { return c[static_cast<std::size_t>(criterion)]; }

TEST(ChoiceCost, the_first_criterion_that_differs_decides) {
  const Cost a = cost({{Criterion::narrow, 1}, {Criterion::defect, 0.2}}), b = cost({{Criterion::defect, 0.3}});
  EXPECT_EQ(difference(a, b), Criterion::narrow);
  EXPECT_EQ(difference(a, a), std::nullopt);
}

TEST(ChoiceCost, defects_within_1e_6_and_sides_within_a_thousandth_are_equal) {
  const Cost a = cost({{Criterion::defect, 0.3}, {Criterion::sides, -1}});
  EXPECT_EQ(difference(a, cost({{Criterion::defect, 0.3 + 5e-7}, {Criterion::sides, -1.0005}})), std::nullopt);
  EXPECT_EQ(difference(a, cost({{Criterion::defect, 0.3 + 5e-6}, {Criterion::sides, -1}})), Criterion::defect);
  EXPECT_EQ(difference(a, cost({{Criterion::defect, 0.3}, {Criterion::sides, -1.002}})), Criterion::sides);
}

class OnePlate : public ::testing::Test {
 protected:
  const Field field = adapted_field(plate(10, 6, {0, 0, 1, 0}));
  const field::FieldEvaluator evaluator{field};
  const TieOrbits ties = tie_orbits(field.mesh.face);
  const CostMeasure measure{evaluator, ties};
};

TEST_F(OnePlate, both_larger_with_a_node_have_better_angles_than_one_of_each) {
  CriticalPoints with_node;
  with_node.critical_points = {node({5, 3}, 1)};
  EXPECT_NEAR(figure(measure({false, false}, with_node), Criterion::defect), 2 * 0.125 + 0.1, 1e-12);
  EXPECT_NEAR(figure(measure({true, false}, {}), Criterion::defect), 0.25 + 0.125, 1e-12);
}

TEST_F(OnePlate, nodes_with_little_room_are_counted) {
  CriticalPoints points;
  points.critical_points = {node({5, 3}, 1), node({9, 3}, 1), node({0.01, 3}, 1)};
  const Cost c = measure({false, false}, points);
  EXPECT_EQ(figure(c, Criterion::crowded), 1);
  EXPECT_EQ(figure(c, Criterion::narrow), 2);
}

TEST_F(OnePlate, the_least_cost_is_that_of_the_fewest_nodes) {
  CriticalPoints with_node;
  with_node.critical_points = {node({5, 3}, 1)};
  EXPECT_EQ(difference(measure.least({false, false}, 1, 6), measure({false, false}, with_node)), std::nullopt);
  EXPECT_EQ(difference(measure.least({true, false}, 0, 6), measure({true, false}, {})), std::nullopt);
}

TEST(ChoiceCost, nodes_of_a_narrow_face_have_little_room_wherever_they_are) {
  const Field field = adapted_field(plate(10, 0.4, {0, 0, 0.15, 0}));
  const field::FieldEvaluator evaluator(field);
  const TieOrbits ties = tie_orbits(field.mesh.face);
  const CostMeasure measure(evaluator, ties);
  EXPECT_EQ(figure(measure.least({false, false}, 1, 6), Criterion::narrow), 1);
  EXPECT_EQ(figure(measure.least({false, false}, -3, 6), Criterion::narrow), 2);
  EXPECT_EQ(figure(measure.least({true, false}, 0, 6), Criterion::narrow), 0);
}

TEST_F(OnePlate, the_smaller_valence_belongs_to_the_longer_sides) {
  // Joint 2 has sides of 5 and 1.4, joint 3 of 1.4 and 9.
  EXPECT_EQ(difference(measure({true, false}, {}), measure({false, true}, {})), Criterion::sides);
  EXPECT_LT(figure(measure({false, true}, {}), Criterion::sides), figure(measure({true, false}, {}), Criterion::sides));
}

TEST(ChoiceCost, mirror_images_with_different_valences_are_counted) {
  const Field field = adapted_field(plate(6, 6, {1, 1, 1, 1}));
  const field::FieldEvaluator evaluator(field);
  const TieOrbits ties = tie_orbits(field.mesh.face);
  const CostMeasure measure(evaluator, ties);
  EXPECT_EQ(figure(measure({true, false}, {}), Criterion::halved), 1);
  EXPECT_EQ(figure(measure({true, true}, {}), Criterion::halved), 0);
}

}  // namespace
}  // namespace quadrille::ties
