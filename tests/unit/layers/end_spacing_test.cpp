#include "layers/end_spacing.hpp"

#include <gtest/gtest.h>

namespace quadrille::layers {
namespace {

const EndSpacing free_end, layers_of_three{{0.01, 0.03, 0.07}, 0.04, 1.5};

TEST(EndSpacing, TheFreePartLiesBetweenTheLayersOfBothEnds) {
  const FreePart part = free_part({layers_of_three, {{0.1}, 0.2, 1.2}}, 2, 0.3);
  EXPECT_NEAR(part.length, 2 * (1 - 0.07 - 0.1), 1e-15);
  EXPECT_EQ(part.layers, 4);
  EXPECT_EQ(part.ends.before, 0.04);
  EXPECT_EQ(part.ends.after, 0.2);
  EXPECT_EQ(part.size, 0.3);
  const FreePart all = free_part({}, 2, 0.3);
  EXPECT_EQ(all.length, 2);
  EXPECT_TRUE(all.ends.are_free());
}

TEST(EndSpacing, FreeEndsMakeEqualIntervals) {
  const std::vector<double> ends = spaced_ends({}, 3, 0.1, 4);
  ASSERT_EQ(ends.size(), 5u);
  for (int k = 0; k <= 4; ++k) EXPECT_NEAR(ends[k], k / 4.0, 1e-15);
}

TEST(EndSpacing, LayersStayWhereTheyArePrescribedAtBothEnds) {
  const std::vector<double> ends = spaced_ends({layers_of_three, {{0.1}, 0.1, 1.2}}, 1, 0.1, 12);
  ASSERT_EQ(ends.size(), 13u);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(ends[k + 1], layers_of_three.layer_ends[k]);
  EXPECT_EQ(ends[11], 1 - 0.1);
  EXPECT_EQ(ends.front(), 0);
  EXPECT_EQ(ends.back(), 1);
  for (std::size_t k = 1; k < ends.size(); ++k) EXPECT_GT(ends[k], ends[k - 1]);
}

TEST(EndSpacing, IntervalsGrowFromThePrescribedOne) {
  const std::vector<double> ends = spaced_ends({{{{}, 0.01, 1.2}, free_end}}, 1, 0.2, 12);
  double last = 0.01;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    EXPECT_GT(ends[k] - ends[k - 1], last);
    last = ends[k] - ends[k - 1];
  }
}

TEST(EndSpacing, TheEvenSizeIsThePrescribedOneOrTheLeastWithWhichIntervalsGrowEvenly) {
  const ArcSpacing spacing{{{{0.01}, 0.01, 1.2}, {}}};
  const auto greatest_growth = [&](double size, int count) {
    const std::vector<double> ends = spaced_ends(spacing, 1, size, count);
    double greatest = 1;
    for (std::size_t k = 2; k < ends.size(); ++k)
      greatest = std::max(greatest, (ends[k] - ends[k - 1]) / (ends[k - 1] - ends[k - 2]));
    return greatest;
  };
  EXPECT_EQ(even_size(spacing, 1, 0.1, 1.2, 40), 0.1) << "many intervals";
  const double some = even_size(spacing, 1, 0.1, 1.2, 18);
  EXPECT_GT(some, 0.1);
  EXPECT_NEAR(greatest_growth(some, 18), 1.2, 1e-3);
  const double few = even_size(spacing, 1, 0.1, 1.2, 9);
  EXPECT_NEAR(greatest_growth(few, 9), 1.5702, 1e-3) << "1 + q + ... + q^8 = 100";
  EXPECT_EQ(even_size({}, 1, 0.1, 1.2, 3), 0.1) << "without prescribed ends";
}

}  // namespace
}  // namespace quadrille::layers
