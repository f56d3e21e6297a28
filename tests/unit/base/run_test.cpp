#include "base/run.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(RunOfAStage, KeepsTheReportAndIsSilent) {
  quadrille::Run run(3);
  EXPECT_EQ(run.threads(), 3);
  EXPECT_EQ(quadrille::Run().threads(), 1);
  testing::internal::CaptureStderr();
  run.begin_phase("work");
  run.info("a sentence", 0);
  run.report().warn("W-X-001", "odd");
  run.end_phase();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_EQ(run.report().warnings().size(), 1U);
  EXPECT_TRUE(run.report().entries().empty()) << "no times";
}

}  // namespace
}  // namespace quadrille
