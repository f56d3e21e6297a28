#include "prescribe/flat_plate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::prescribe {
namespace {

constexpr PlateFlow air{30, 1.5e-5, 1};  // Re = 2e6

TEST(FlatPlate, HeightIsThatOfSchlichtingsSkinFriction) {
  EXPECT_NEAR(air.reynolds_number(), 2e6, 1e-6);
  EXPECT_NEAR(air.skin_friction(), 3.3256e-3, 1e-7) << "(2 log10 2e6 - 0.65)^-2.3";
  EXPECT_NEAR(air.height(1), 1.2262e-5, 1e-9) << "1.5e-5 / (30 sqrt(c_f / 2))";
  EXPECT_NEAR(air.height(30) / air.height(1), 30, 1e-12);
}

TEST(FlatPlate, HeightFollowsTheUnitOfLength) {
  const PlateFlow in_millimetres{30e3, 15, 1000};
  EXPECT_NEAR(in_millimetres.height(1), 1000 * air.height(1), 1e-12);
}

TEST(FlatPlate, MissingAndUselessOptionsAreRefusedByName) {
  const auto refusal = [](const PlateFlow& flow, bool is_used) {
    return message_of<UsageError>([&] { flow.validate(is_used); });
  };
  EXPECT_EQ(refusal(air, true), "");
  EXPECT_EQ(refusal({}, false), "");
  expect_contains(refusal({30, 0, 0}, true), "--viscosity, --length");
  expect_contains(refusal({0, 1.5e-5, 1}, true), "--velocity");
  expect_contains(refusal({30, 0, 0}, false), "--velocity: used with --yplus");
  expect_contains(refusal({30, 1.5e-5, 1e-5}, true), "Reynolds number is 20");
}

TEST(FlatPlate, TheReportHasTheFlowAndAWarningOutsideTheFormulasInterval) {
  Report inside, outside;
  report_flow(air, inside);
  EXPECT_TRUE(inside.warnings().empty());
  EXPECT_EQ(inside.entries().front().first, "flow.reynolds_number");
  report_flow({30, 1.5e-5, 0.01}, outside);
  ASSERT_EQ(outside.warnings().size(), 1u);
  EXPECT_EQ(outside.warnings()[0].code, "W-SIZ-001");
}

}  // namespace
}  // namespace quadrille::prescribe
