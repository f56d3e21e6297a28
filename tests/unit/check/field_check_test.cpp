#include <gtest/gtest.h>

#include <limits>

#include "../region_samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

constexpr int least = std::numeric_limits<int>::min();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <typename Damage>
Rules broken(const Damage& damage) {
  Field field = samples::field();
  field.liftings = {{0, {0, 0}, {-1, -1}, {1, 0}}};
  return broken_rules(field, damage);
}

TEST(FieldCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](Field&) {}), Rules{});
}

TEST(FieldCheck, FldR01ArraysAgree) {
  EXPECT_EQ(broken([](Field& f) { f.elem_order.pop_back(); }), Rules{"FLD-R01"});
  EXPECT_EQ(broken([](Field& f) { f.elem_sensor.pop_back(); }), Rules{"FLD-R01"});
  EXPECT_EQ(broken([](Field& f) { f.elem_error.pop_back(); }), Rules{"FLD-R01"});
}
TEST(FieldCheck, FldR02CoefficientsFit) {
  EXPECT_EQ(broken([](Field& f) { f.elem_order[1] = 2; }), Rules{"FLD-R02"});
  EXPECT_EQ(broken([](Field& f) { f.elem_order[1] = 0; }), Rules{"FLD-R02"});
  EXPECT_EQ(broken([](Field& f) { f.v.pop_back(); }), Rules{"FLD-R02"});
  EXPECT_EQ(broken([](Field& f) { f.coef_offsets.clear(); }), Rules{"FLD-R02"});
}
TEST(FieldCheck, FldR03JointsExist) {
  EXPECT_EQ(broken([](Field& f) { f.liftings[0].joint = 4; }), Rules{"FLD-R03"});
}
TEST(FieldCheck, FldR04NumbersAreFinite) {
  EXPECT_EQ(broken([](Field& f) { f.v[3] = std::numeric_limits<double>::infinity(); }), Rules{"FLD-R04"});
  EXPECT_EQ(broken([](Field& f) { f.liftings[0].jump.y = std::numeric_limits<double>::quiet_NaN(); }),
            Rules{"FLD-R04"});
}
TEST(FieldCheck, FldR05KindsAreKnown) {
  EXPECT_EQ(broken([](Field& f) { f.kind = static_cast<FieldKind>(7); }), Rules{"FLD-R05"});
  EXPECT_EQ(broken([](Field& f) { f.method = static_cast<FieldMethod>(7); }), Rules{"FLD-R05"});
}
TEST(FieldCheck, FldR06LiftingsFitTheirJoints) {
  EXPECT_EQ(broken([](Field& f) { f.liftings[0].joint = 1; }), Rules{"FLD-R06"});
  EXPECT_EQ(broken([](Field& f) { f.liftings.push_back(f.liftings[0]); }), Rules{"FLD-R06"});
  EXPECT_EQ(broken([](Field& f) { f.liftings[0].pole = f.liftings[0].apex; }), Rules{"FLD-R06"});
}
TEST(FieldCheck, FldR07AdaptStepsAreSound) {
  EXPECT_EQ(broken([](Field& f) { f.adapt_steps[0].num_raised = -1; }), Rules{"FLD-R07"});
  EXPECT_EQ(broken([](Field& f) { f.adapt_steps[0].min_order = 3; }), Rules{"FLD-R07"});
  EXPECT_EQ(broken([](Field& f) { f.adapt_steps[0].elem_order.pop_back(); }), Rules{"FLD-R07"});
}
TEST(FieldCheck, FldR08ErrorsAreNotNegative) {
  EXPECT_EQ(broken([](Field& f) { f.elem_error[0] = -1e-9; }), Rules{"FLD-R08"});
}

template <typename Damage>
Rules broken_phase(const Damage& damage) {
  return broken_rules(samples::phase_field(), damage);
}

TEST(FieldCheck, ThePhaseSampleIsValid) {
  EXPECT_EQ(broken_phase([](Field&) {}), Rules{});
}

TEST(FieldCheck, FldR02CoefficientsOfAPhaseFit) {
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.s.pop_back(); }), Rules{"FLD-R02"});
  EXPECT_EQ(broken_phase([](Field& f) { f.u.assign(15, 0.0); }), Rules{"FLD-R02"});
  EXPECT_EQ(broken_phase([](Field& f) { f.kind = FieldKind::harmonic; }), Rules{"FLD-R02"});
}
TEST(FieldCheck, FldR04CoefficientsOfAPhaseAreFinite) {
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.s[3] = std::numeric_limits<double>::infinity(); }), Rules{"FLD-R04"});
}
TEST(FieldCheck, FldR11TheAlignmentIsSound) {
  const auto with = [](AlignmentPoint point) { return broken([&](Field& f) { f.alignment = {point}; }); };
  EXPECT_EQ(with({{0, 0}, 0.1, 5, 1}), Rules{});
  EXPECT_EQ(with({{0, 0}, 0, 5, 1}), Rules{"FLD-R11"});
  EXPECT_EQ(with({{0, 0}, 0.1, -5, 1}), Rules{"FLD-R11"});
  EXPECT_EQ(with({{0, 0}, 0.1, 5, not_a_number}), Rules{"FLD-R11"});
}

TEST(FieldCheck, FldR09PhaseIsSound) {
  EXPECT_EQ(broken_phase([](Field& f) { f.liftings = {{0, {0, 0}, {-1, -1}, {1, 0}}}; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.terms.images[0].position.x = not_a_number; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.terms.images[0].turns = 2000000; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.terms.images[0].turns = least; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.terms.corner_angles[0].pole = {0, 0}; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.terms.corner_angles[0].beta = not_a_number; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) {
              f.phase.terms.holes = {{{0.5, 0.5}, 4}};
            }),
            Rules{"FLD-R09"})
      << "the square has no hole";
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.hole_winding = {0}; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.hole_winding_offsets = {0}; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.best_hole_winding = {0.5}; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.hole_periods = {0.5}; }), Rules{"FLD-R09"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.hole_winding_energy = not_a_number; }), Rules{"FLD-R09"});
}
TEST(FieldCheck, FldR10TermsAreThoseAskedFor) {
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.terms.nodes[0].turns = -1; }), Rules{"FLD-R10"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.terms.nodes[0].position.x += 1e-9; }), Rules{"FLD-R10"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.terms.nodes.clear(); }), Rules{"FLD-R10"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.prescribed.nodes[0].valence = least; }), Rules{"FLD-R10"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.prescribed.corners[0].joint = 4; }), Rules{"FLD-R10"});
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.prescribed.corners[1].joint = 0; }), Rules{"FLD-R10"}) << "twice";
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.prescribed.corners[0].valence = 1; }), Rules{"FLD-R10"}) << "index sum";
  EXPECT_EQ(broken_phase([](Field& f) { f.phase.prescribed.corners[0].valence = least; }), Rules{"FLD-R10"});
  // A boundary node of valence 3 takes what a corner of valence 1 instead of 2 gives.
  const auto with_boundary_node = [](int curve, double t, int valence) {
    return broken_phase([&](Field& f) {
      f.phase.prescribed.corners[0].valence = 1;
      f.phase.prescribed.boundary_nodes = {{curve, t, valence}};
    });
  };
  EXPECT_EQ(with_boundary_node(1, 0.5, 3), Rules{});
  EXPECT_EQ(with_boundary_node(4, 0.5, 3), Rules{"FLD-R10"});
  EXPECT_EQ(with_boundary_node(1, 1.5, 3), Rules{"FLD-R10"});
  EXPECT_EQ(with_boundary_node(1, std::numeric_limits<double>::quiet_NaN(), 3), Rules{"FLD-R10"});
  EXPECT_EQ(with_boundary_node(1, 0.5, 2), Rules{"FLD-R10"});
  EXPECT_EQ(with_boundary_node(1, 0.5, least), Rules{"FLD-R10"});
}

TEST(FieldCheck, FieldsOfRegionsAreValid) {
  EXPECT_EQ(broken_rules(samples::two_regions_field(), [](Field&) {}), Rules{});
}

template <typename Damage>
Rules broken_phases(const Damage& damage) {
  return broken_rules(samples::two_regions_phase_field(), damage);
}

TEST(FieldCheck, PhasesOfRegionsHaveNumbersOfTheirOwn) {
  EXPECT_EQ(broken_phases([](Field&) {}), Rules{});
  const auto second = [](auto&& damage) { return broken_phases([&](Field& f) { damage(f.region_phases[1]); }); };
  EXPECT_EQ(broken_phases([](Field& f) { f.region_phases.pop_back(); }), Rules{"FLD-R02"});
  EXPECT_EQ(second([](PhaseForm& p) { p.s.pop_back(); }), Rules{"FLD-R02"});
  EXPECT_EQ(second([](PhaseForm& p) { p.s[2] = not_a_number; }), Rules{"FLD-R04"});
  EXPECT_EQ(second([](PhaseForm& p) { p.hole_winding = {1}; }), Rules{"FLD-R09"});
  EXPECT_EQ(second([](PhaseForm& p) { p.prescribed.corners[3].joint = 4; }), Rules{"FLD-R10"});
  EXPECT_EQ(second([](PhaseForm& p) { p.prescribed.corners[3].valence = 2; }), Rules{"FLD-R10"}) << "index sum";
  EXPECT_EQ(second([](PhaseForm& p) {
              p.prescribed.corners[3].valence = 2;
              p.prescribed.boundary_nodes = {{3, 0.5, 1}};
            }),
            Rules{});
  EXPECT_EQ(second([](PhaseForm& p) {
              p.prescribed.corners[3].valence = 2;
              p.prescribed.boundary_nodes = {{4, 0.5, 1}};
            }),
            Rules{"FLD-R10"});
}

}  // namespace
}  // namespace quadrille::check
