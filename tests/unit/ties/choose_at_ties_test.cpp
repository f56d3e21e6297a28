#include "ties/choose_at_ties.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/polygon_field.hpp"
#include "galerkin/solve_phase.hpp"
#include "plates.hpp"

namespace quadrille::ties {
namespace {

using namespace testing_faces;

CriticalPoints chosen(const CadFace& face, Report& report) {
  const Field field = adapted_field(face);
  const field::FieldEvaluator evaluator(field);
  galerkin::PhaseSolver solver(field.mesh, field.elem_order);
  const auto solve = [&](const auto& data, const std::vector<int>& elem_order, double negligible) {
    solver.set_orders(elem_order);
    return solver.harmonic_parts(data, negligible);
  };
  const CriticalPoints points = choose_at_ties(evaluator, tie_orbits(field.mesh.face), solve, {}, report);
  EXPECT_EQ(points.form, NodeForm::phase);
  EXPECT_EQ(index_sum_of(points), 4 * face.euler_characteristic());
  return points;
}

CriticalPoints chosen(const CadFace& face) {
  Report report;
  return chosen(face, report);
}

std::vector<int> corner_valences(const CriticalPoints& points) {
  std::vector<int> valences;
  for (const Corner& c : points.corners) valences.push_back(c.valence);
  return valences;
}

std::vector<int> node_valences(const CriticalPoints& points) {
  std::vector<int> valences;
  for (const CriticalPoint& p : points.critical_points) valences.push_back(p.valence);
  std::sort(valences.begin(), valences.end());
  return valences;
}

TEST(ChooseAtTies, a_small_chamfer_has_one_of_each_and_no_node) {
  for (const double angle : {44.0, 44.98, 45.0, 45.02, 46.0}) {
    const CriticalPoints points = chosen(plate(10, 6, {0, 0, 1, 0}, angle));
    EXPECT_EQ(corner_valences(points), (std::vector<int>{1, 1, 2, 1, 1})) << angle;
    EXPECT_TRUE(points.critical_points.empty()) << angle;
  }
}

TEST(ChooseAtTies, a_large_chamfer_has_two_of_the_larger_and_a_node_of_valence_3) {
  for (const double angle : {44.98, 45.0, 45.02}) {
    const CriticalPoints points = chosen(plate(10, 6, {0, 0, 4, 0}, angle));
    EXPECT_EQ(corner_valences(points), (std::vector<int>{1, 1, 2, 2, 1})) << angle;
    EXPECT_EQ(node_valences(points), std::vector<int>{3}) << angle;
  }
}

TEST(ChooseAtTies, a_chamfer_far_from_a_hole_is_decided) {
  for (const double angle : {44.98, 45.0, 45.02}) {
    const CadFace face = make_face({plate_outline(20, 6, {0, 0, 0.5, 0}, angle), hole({3, 3}, 1)});
    const CriticalPoints points = chosen(face);
    EXPECT_EQ(corner_valences(points), (std::vector<int>{1, 1, 2, 1, 1})) << angle;
    EXPECT_EQ(node_valences(points), (std::vector<int>{5, 5, 5, 5})) << angle;
  }
}

TEST(ChooseAtTies, symmetric_chamfers_have_equal_valences_and_symmetric_nodes) {
  const CriticalPoints points = chosen(plate(6, 6, {1, 1, 1, 1}));
  EXPECT_EQ(corner_valences(points), std::vector<int>(8, 2));
  ASSERT_EQ(node_valences(points), (std::vector<int>{3, 3, 3, 3}));
  for (const CriticalPoint& p : points.critical_points) {
    EXPECT_NEAR(std::abs(p.position.x - 3), std::abs(p.position.y - 3), 1e-6);
    EXPECT_NEAR(std::abs(p.position.x - 3), std::abs(points.critical_points[0].position.x - 3), 1e-6);
  }
}

TEST(ChooseAtTies, mirror_images_differ_only_where_a_node_has_hardly_any_room) {
  Report report;
  const CriticalPoints points = chosen(plate(6, 6, {0.01, 0.01, 0.01, 0.01}), report);
  EXPECT_TRUE(points.critical_points.empty());
  EXPECT_EQ(std::count_if(points.corners.begin(), points.corners.end(), [](const Corner& c) { return c.valence == 1; }),
            4);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings()[0].code, "W-NODE-001");
}

TEST(ChooseAtTies, an_octagon_keeps_its_central_nodes) {
  std::vector<Vec2> corners;
  for (int k = 0; k < 8; ++k) corners.push_back(unit(pi / 8 + k * pi / 4));
  const CriticalPoints points = chosen(make_face({polygon(corners)}));
  EXPECT_EQ(corner_valences(points), std::vector<int>(8, 2));
  EXPECT_EQ(node_valences(points), (std::vector<int>{3, 3, 3, 3}));
}

TEST(ChooseAtTies, a_corner_of_45_degrees_gets_a_block) {
  for (const double angle : {44.0, 45.0, 46.0}) {
    const double y = 4 * std::tan(radians(angle));
    const CriticalPoints points = chosen(make_face({polygon({{0, 0}, {4, 0}, {0, y}})}));
    EXPECT_EQ(corner_valences(points), (std::vector<int>{1, 1, 1})) << angle;
    EXPECT_EQ(node_valences(points), std::vector<int>{3}) << angle;
  }
}

TEST(ChooseAtTies, many_chamfers_are_decided_one_after_the_other) {
  Report report;
  const CriticalPoints points = chosen(plate(12, 7, {0.5, 0.6, 0.7, 0.8}), report);
  EXPECT_EQ(node_valences(points), std::vector<int>{});
  for (std::size_t chamfer = 0; chamfer < 4; ++chamfer)
    EXPECT_EQ(points.corners[2 * chamfer].valence + points.corners[2 * chamfer + 1].valence, 3);
}

TEST(ChooseAtTies, choices_whose_nodes_cost_too_much_are_not_searched) {
  // Octagonal holes: most choices of two corners make a pair of nodes that no other choice needs.
  std::vector<Loop> loops{polygon({{0, 0}, {12, 0}, {12, 4}, {0, 4}})};
  for (int i = 0; i < 3; ++i) {
    std::vector<Vec2> corners;
    for (int k = 0; k < 8; ++k) corners.push_back(Vec2{4 * i + 2.0, 2} + (0.9 + 0.07 * i) * unit(0.3 * i - k * pi / 4));
    loops.push_back(polygon(corners));
  }
  Report report;
  const CriticalPoints points = chosen(make_face(loops), report);
  EXPECT_LT(points.critical_points.size(), 4u);
  const auto& entries = report.entries();
  const auto searches =
      std::find_if(entries.begin(), entries.end(), [](const auto& e) { return e.first == "ties.searches"; });
  EXPECT_LT(std::get<long long>(searches->second), 30);
}

TEST(ChooseAtTies, each_tie_is_recorded_with_its_reason) {
  const CriticalPoints points = chosen(plate(10, 6, {0, 0, 1, 0}));
  ASSERT_EQ(points.changes.size(), 2u);
  for (const NodeChange& change : points.changes) {
    EXPECT_EQ(change.kind, ChangeKind::line);
    EXPECT_NE(change.reason.find("135 degrees"), std::string::npos);
    EXPECT_NE(change.reason.find("because"), std::string::npos);
  }
}

}  // namespace
}  // namespace quadrille::ties
