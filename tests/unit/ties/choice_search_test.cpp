#include "ties/choice_search.hpp"

#include <gtest/gtest.h>

#include <map>

#include "../support/polygon_field.hpp"
#include "galerkin/solve_phase.hpp"
#include "plates.hpp"

namespace quadrille::ties {
namespace {

using namespace testing_faces;

PartSolver parts_by(galerkin::PhaseSolver& solver) {
  return [&](const auto& data, const std::vector<int>& elem_order, double negligible) {
    solver.set_orders(elem_order);
    return solver.harmonic_parts(data, negligible);
  };
}

std::vector<zeros::FoundZero> zeros_by_full_search(const field::FieldEvaluator& evaluator) {
  zeros::ZeroSearch search(evaluator, {});
  for (int e = 0; e < evaluator.field().mesh.num_elems(); ++e) search.search(e);
  return zeros::distinct_zeros(evaluator, search.zeros());
}

TEST(ChoiceSearch, zeros_of_later_choices_are_those_of_a_search_of_all_elements) {
  const Field field = adapted_field(plate(12, 7, {0.5, 0.6, 0.7, 3}));
  galerkin::PhaseSolver solver(field.mesh, field.elem_order);
  const TieOrbits ties = tie_orbits(field.mesh.face);
  TiltedField tilted(field, ties, parts_by(solver));
  ChoiceSearch search(tilted, zeros::field_noise);
  Choice choice(ties.units.size(), false);
  for (std::size_t u = 0; u < choice.size(); ++u) {
    choice[u] = true;
    const field::FieldEvaluator& evaluator = tilted.with(choice);
    const auto found = zeros::distinct_zeros(evaluator, search.zeros_of(choice).zeros);
    const auto expected = zeros_by_full_search(evaluator);
    EXPECT_EQ(zeros::distinct_zeros(evaluator, search.likely_zeros_of(choice).zeros).size(), expected.size()) << u;
    ASSERT_EQ(found.size(), expected.size()) << u;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].index, expected[i].index);
      EXPECT_LT(distance(found[i].x, expected[i].x), 1e-6 * field.mesh.face.diameter);
    }
    if (u % 2 == 0) search.keep_last();
    choice[u] = u % 2 == 1;
  }
}

/// A row of teeth with chamfers at their tops: two ties at each chamfer.
CadFace rack(int teeth) {
  std::vector<Vec2> points{{0, -2}, {2.0 * teeth, -2}};
  for (double x = 2.0 * teeth; x > 0; x -= 2)
    points.insert(points.end(), {{x, 1}, {x - 0.7, 1}, {x - 1, 0.7}, {x - 1, 0}, {x - 2, 0}});
  return make_face({polygon(points)});
}

TEST(ChoiceSearch, a_choice_examines_few_cells_however_many_ties_there_are) {
  for (const int teeth : {4, 12}) {
    const Field field = adapted_field(rack(teeth));
    galerkin::PhaseSolver solver(field.mesh, field.elem_order);
    const TieOrbits ties = tie_orbits(field.mesh.face);
    ASSERT_EQ(ties.units.size(), 2u * teeth);
    TiltedField tilted(field, ties, parts_by(solver));
    ChoiceSearch search(tilted, zeros::field_noise);
    Choice choice(ties.units.size(), false);
    search.zeros_of(choice);
    search.keep_last();
    EXPECT_GE(search.num_examined(), field.mesh.num_elems());
    const auto examined_for = [&](std::vector<std::size_t> smaller) {
      const long long before = search.num_examined();
      choice.assign(choice.size(), false);
      for (const std::size_t unit : smaller) choice[unit] = true;
      search.zeros_of(choice);
      return search.num_examined() - before;
    };
    EXPECT_LT(examined_for({3}), 250) << teeth;
    EXPECT_LT(examined_for({3, 7}), 500) << teeth;
    search.keep_last();
    EXPECT_LT(examined_for({7}), 250) << teeth;
    EXPECT_LT(examined_for({3, 7}), 10) << "what was kept";
  }
}

TEST(TiltedField, parts_of_many_units_take_memory_in_proportion_to_the_face) {
  std::vector<double> of_a_unit;
  for (const int teeth : {12, 24}) {
    const Field field = adapted_field(rack(teeth));
    galerkin::PhaseSolver solver(field.mesh, field.elem_order);
    const TieOrbits ties = tie_orbits(field.mesh.face);
    const TiltedField tilted(field, ties, parts_by(solver));
    of_a_unit.push_back(static_cast<double>(tilted.num_numbers()) / static_cast<double>(ties.units.size()));
  }
  EXPECT_LT(of_a_unit[1], 1.4 * of_a_unit[0]);
}

TEST(TiltedField, changes_are_bounded_where_they_are) {
  const Field field = adapted_field(plate(12, 7, {0, 0, 1, 0}));
  galerkin::PhaseSolver solver(field.mesh, field.elem_order);
  const TieOrbits ties = tie_orbits(field.mesh.face);
  TiltedField tilted(field, ties, parts_by(solver));
  const Choice first{false, false}, second{true, false};
  std::map<int, double> changes;
  for (const auto& [elem, most] : tilted.changes(0)) changes[elem] = most;
  Vec2 before, after;
  for (const Vec2 x : {Vec2{10.5, 6}, Vec2{9, 5}, Vec2{1, 1}}) {
    const int elem = tilted.with(first).locator().find(x).elem;
    tilted.with(first).value_at(x, before);
    tilted.with(second).value_at(x, after);
    EXPECT_LE(norm(after - before), changes[elem]);
    EXPECT_LE(changes[elem], 8 * norm(after - before) + 1e-3);
  }
}

}  // namespace
}  // namespace quadrille::ties
