#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "sheet_samples.hpp"

namespace quadrille::page {
namespace {

TEST(ChartSheet, TrianglesAreCellsWithTheirScale) {
  const Sheet sheet = stage_sheet(samples::charted_face(), frame);
  EXPECT_EQ(sheet.caption, "2 triangles of order 2 on 1 surface");
  ASSERT_EQ(sheet.facts.size(), 5u);
  EXPECT_EQ(sheet.facts[2].value, "1.333") << "2 / (1 + r^2) at (1/2, 1/2)";
  EXPECT_EQ(sheet.facts[3].value, "2");
  const std::string layer = layer_of(sheet, "mesh");
  expect_counts(layer, {{R"("title":"length in space / length in the chart")", 1}, {R"("log":true)", 1}});
  EXPECT_TRUE(sheet.space.empty());
}

}  // namespace
}  // namespace quadrille::page
