#include "cad/periodic_options.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::cad {
namespace {

PeriodicRequest request(const std::string& option) { return periodic_options({option}).at(0); }

TEST(PeriodicOptions, NamesAloneLeaveTheMotionToTheCurves) {
  const PeriodicRequest names = request("left=right");
  EXPECT_EQ(names.first, "left");
  EXPECT_EQ(names.second, "right");
  EXPECT_FALSE(names.motion);
  EXPECT_EQ(names.where, "--periodic left=right");
  EXPECT_TRUE(periodic_options({}).empty());
}

TEST(PeriodicOptions, ATranslationIsItsShift) {
  const GivenMotion motion = request("a=b:translate=1.5,-2").motion.value();
  EXPECT_EQ(motion.angle, 0);
  EXPECT_EQ(motion.shift, (Vec2{1.5, -2}));
}

/// The centre stays: R c + shift = c.
TEST(PeriodicOptions, ARotationKeepsItsCentre) {
  const GivenMotion about_origin = request("a=b:rotate=90").motion.value();
  EXPECT_DOUBLE_EQ(about_origin.angle, half_pi);
  EXPECT_EQ(about_origin.shift, (Vec2{0, 0}));
  const GivenMotion motion = request("a=b:rotate=90,2,1").motion.value();
  EXPECT_NEAR(motion.shift.x, 2 + 1, 1e-15);
  EXPECT_NEAR(motion.shift.y, 1 - 2, 1e-15);
}

TEST(PeriodicOptions, NamesMayHaveColons) {
  const PeriodicRequest named = request("a:1=b:2:translate=1,0");
  EXPECT_EQ(named.first, "a:1");
  EXPECT_EQ(named.second, "b:2");
}

TEST(PeriodicOptions, AnythingElseIsRefused) {
  const std::string expected =
      ": expected A=B, A=B:translate=DX,DY or A=B:rotate=DEGREES[,CX,CY], where A and B are names of curves";
  for (const std::string option :
       {"a", "=b", "a=", "a=b:translate=1", "a=b:translate=1,2,3", "a=b:rotate=", "a=b:rotate=1,2", "a=b:rotate=nan",
        "a=b:translate=1,2:rotate=90", "a=b:rotate=90:translate=1,2", ""})
    EXPECT_EQ(message_of<UsageError>([&] { request(option); }), "--periodic " + option + expected);
  EXPECT_EQ(message_of<UsageError>([] { request("a=a"); }),
            "--periodic a=a: both sides have one name; give them two names (--name)");
}

}  // namespace
}  // namespace quadrille::cad
