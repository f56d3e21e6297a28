#include "layout/layout_options.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::layout {
namespace {

std::string refusal(const LayoutOptions& options) {
  return message_of<UsageError>([&] { options.validate(); });
}

TEST(LayoutOptions, IntervalsAreChecked) {
  LayoutOptions options;
  EXPECT_EQ(refusal(options), "");
  for (const double wrong : {-1.0, std::nan("")}) {
    options.max_deviation = wrong;
    EXPECT_EQ(refusal(options), "the greatest deviation must not be negative");
  }
  options.max_deviation = 0, options.max_lines = 0;
  EXPECT_EQ(refusal(options), "the greatest number of arcs must be positive");
  options.max_lines = 1, options.trace.merge_distance = std::nan("");
  EXPECT_EQ(refusal(options), "step, merge distance and merge angle must not be negative");
}

TEST(SimplifyOptions, TheCoarsestLayoutHasLowerBounds) {
  LayoutOptions options;
  const simplify::SimplifyOptions normal = simplify_options(options);
  EXPECT_TRUE(normal.limits_loss_by_saving);
  EXPECT_DOUBLE_EQ(normal.max_deviation, radians(40));
  options.simplify = SimplifyLevel::coarsest;
  const simplify::SimplifyOptions coarsest = simplify_options(options);
  EXPECT_FALSE(coarsest.limits_loss_by_saving);
  EXPECT_LT(coarsest.least_scaled_jacobian, normal.least_scaled_jacobian);
  EXPECT_DOUBLE_EQ(coarsest.max_deviation, radians(45));
}

TEST(SimplifyOptions, TheDeviationIsThatOfTheUserButForTheCoarsestLayout) {
  LayoutOptions options;
  options.max_deviation = 10;
  EXPECT_DOUBLE_EQ(simplify_options(options).max_deviation, radians(10));
  options.simplify = SimplifyLevel::coarsest;
  EXPECT_DOUBLE_EQ(simplify_options(options).max_deviation, radians(45));
  options.max_deviation = 60;
  EXPECT_DOUBLE_EQ(simplify_options(options).max_deviation, radians(60));
}

}  // namespace
}  // namespace quadrille::layout
