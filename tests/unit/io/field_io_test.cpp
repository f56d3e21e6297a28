#include <gtest/gtest.h>

#include "../region_layout_samples.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using FieldIo = RoundTrip;

TEST_F(FieldIo, FieldSurvivesTheRoundTrip) {
  expect_same_bytes(samples::field());
  const Field field = read_stage<Field>(read_input(path("second")));
  EXPECT_EQ(field.u, samples::field().u);
  EXPECT_EQ(field.adapt_steps.size(), 1u);
  EXPECT_EQ(field.adapt_steps[0].max_sensor, 1e-9);
  EXPECT_EQ(field.adapt_steps[0].elem_order, samples::field().adapt_steps[0].elem_order);
  EXPECT_EQ(field.adapt_steps[0].elem_sensor, samples::field().adapt_steps[0].elem_sensor);
  EXPECT_EQ(field.elem_error, samples::field().elem_error);
  EXPECT_EQ(stage_format(read_input(path("first"))), "field");
}

TEST_F(FieldIo, PhaseFieldSurvivesTheRoundTrip) {
  expect_same_bytes(samples::phase_field());
  const Field field = read_stage<Field>(read_input(path("second")));
  EXPECT_EQ(field.kind, FieldKind::phase);
  EXPECT_TRUE(field.u.empty());
  EXPECT_EQ(field.phase.s, samples::phase_field().phase.s);
  EXPECT_EQ(field.phase.prescribed.corners[0].valence, 2);
  EXPECT_EQ(field.phase.terms.images[0].position, (Vec2{0.5, -0.375}));
  EXPECT_EQ(field.phase.terms.corner_angles[0].beta, -4);
}

TEST_F(FieldIo, PhasesOfRegionsSurviveTheRoundTrip) {
  const Field expected = samples::two_regions_phase_field();
  expect_same_bytes(expected);
  const Field field = read_stage<Field>(read_input(path("second")));
  ASSERT_EQ(field.region_phases.size(), 2u);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(field.region_phases[r].s, expected.region_phases[r].s);
    EXPECT_EQ(field.region_phases[r].prescribed, expected.region_phases[r].prescribed);
  }
  EXPECT_TRUE(field.phase.s.empty());
}

}  // namespace

}  // namespace quadrille::io
