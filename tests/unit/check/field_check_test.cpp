#include <gtest/gtest.h>

#include <limits>

#include "../samples.hpp"
#include "rules_of.hpp"

namespace quadrille {
namespace {

template <typename Damage>
Rules broken(const Damage& damage) {
  Field field = samples::field();
  field.liftings = {{0, {0, 0}, {-1, -1}, {1, 0}}};
  damage(field);
  return rules_of(check_field(field, CheckDepth::full));
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
  EXPECT_EQ(broken([](Field& f) { f.kind = "magic"; }), Rules{"FLD-R05"});
  EXPECT_EQ(broken([](Field& f) { f.method = "fd"; }), Rules{"FLD-R05"});
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

}  // namespace
}  // namespace quadrille
