#include "base/option_interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille {

namespace option_samples {

struct Shape {
  double width = 1;
  int sides = 4;
};

void declare(Options& options, Shape& shape) {
  options.number("--width", shape.width, 0, 2, "length", "its width");
  options.integer("--sides", shape.sides, 3, 6, "number of its sides");
}

}  // namespace option_samples

namespace {

TEST(IntervalText, NamesTheBoundsThatThereAre) {
  EXPECT_EQ(interval_text(0.5, 20.0), "0.5 to 20");
  EXPECT_EQ(interval_text(0.0, 1e300), "at least 0");
  EXPECT_EQ(interval_text(-1e300, 3.0), "at most 3");
  EXPECT_EQ(interval_text(-1e300, 1e300), "any number");
  EXPECT_EQ(interval_text(1, 20), "1 to 20");
  EXPECT_EQ(interval_text(1, std::numeric_limits<int>::max()), "at least 1");
}

TEST(RequireInInterval, RefusesNumbersOutsideAndTextsThatAreNone) {
  EXPECT_NO_THROW(require_in_interval("--width", 0.0, "0", 0.0, 2.0));
  EXPECT_NO_THROW(require_in_interval("--width", 2.0, "2", 0.0, 2.0));
  EXPECT_EQ(message_of<UsageError>([] { require_in_interval("--width", 2.5, "2.50", 0.0, 2.0); }),
            "--width: 2.50 is outside its interval (0 to 2)");
  EXPECT_THROW(require_in_interval("--width", std::nan(""), "nan", 0.0, 2.0), UsageError);
  EXPECT_EQ(message_of<UsageError>([] { require_in_interval("--sides", 2, "2", 3, 6); }),
            "--sides: 2 is outside its interval (3 to 6)");
}

TEST(RequireIntervals, ChecksEachNumberOfAStruct) {
  EXPECT_NO_THROW(require_intervals(option_samples::Shape{}));
  EXPECT_EQ(message_of<UsageError>([] {
              require_intervals(option_samples::Shape{-0.5, 4});
            }),
            "--width: -0.5 is outside its interval (0 to 2)");
  EXPECT_EQ(message_of<UsageError>([] {
              require_intervals(option_samples::Shape{1, 7});
            }),
            "--sides: 7 is outside its interval (3 to 6)");
}

}  // namespace
}  // namespace quadrille
