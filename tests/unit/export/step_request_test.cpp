#include "export/step_request.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille::exports {
namespace {

TEST(StepRequest, RequestAndModelAreTheSameAfterTheJourney) {
  const std::string bytes("a\0b\0", 4);
  const StepRequest request = step_request(to_bytes(StepRequest{"two\nlines", bytes, {"mm", 0.1, true}, true}));
  EXPECT_EQ(request.name, "two\nlines");
  EXPECT_EQ(request.bytes, bytes);
  EXPECT_EQ(request.length.unit, "mm");
  EXPECT_EQ(request.length.scale, 0.1);
  EXPECT_TRUE(request.length.keeps_unit);
  EXPECT_TRUE(request.block_groups);
  const StepModel model = step_model(to_bytes(StepModel{"ISO", 7, {1 / 3.0, "", 0}}));
  EXPECT_EQ(model.bytes, "ISO");
  EXPECT_EQ(model.num_blocks, 7U);
  EXPECT_EQ(model.length.factor, 1 / 3.0);
  EXPECT_EQ(model.length.unit, "");
}

TEST(StepRequest, AnAnswerThatIsCutOffIsADefect) { EXPECT_THROW(step_model("7"), Defect); }

}  // namespace
}  // namespace quadrille::exports
