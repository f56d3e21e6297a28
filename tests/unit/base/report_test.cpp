#include "base/report.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(Report, KeepsTheSequenceOfFirstUseAndTheLastValue) {
  Report report;
  report.set("b", 1);
  report.set("a", 0.5);
  report.set("b", true);
  ASSERT_EQ(report.entries().size(), 2u);
  EXPECT_EQ(report.entries()[0].first, "b");
  EXPECT_EQ(std::get<bool>(report.entries()[0].second), true);
  EXPECT_EQ(std::get<double>(report.entries()[1].second), 0.5);
}

TEST(Report, KeepsTheKindOfEachValue) {
  Report report;
  report.set("size", std::size_t{7});
  report.set("text", "seven");
  report.set("list", std::vector<double>{1, 2});
  EXPECT_EQ(std::get<long long>(report.entries()[0].second), 7);
  EXPECT_EQ(std::get<std::string>(report.entries()[1].second), "seven");
  EXPECT_EQ(std::get<std::vector<double>>(report.entries()[2].second).size(), 2u);
}

TEST(Report, LeadsToTheProgressThatItWasGiven) {
  Progress progress;
  EXPECT_EQ(Report().progress(), nullptr);
  EXPECT_EQ(Report(&progress).progress(), &progress);
}

TEST(Report, CollectsWarnings) {
  Report report;
  report.warn("W-CAD-001", "something is odd");
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings()[0].code, "W-CAD-001");
}

}  // namespace
}  // namespace quadrille
