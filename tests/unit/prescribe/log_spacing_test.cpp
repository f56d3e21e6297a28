#include "prescribe/log_spacing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quadrille::prescribe {
namespace {

std::vector<double> elements(int count, double length, double first, double last) {
  const std::vector<double> x = LogSpacing(count, length, first, last).positions();
  const std::size_t steps = (x.size() - 1) / count;
  std::vector<double> lengths;
  for (std::size_t k = 0; k + 1 < x.size(); k += steps) lengths.push_back(x[k + steps] - x[k]);
  return lengths;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

TEST(LogSpacing, EveryNumberOfElementsHasBothEndLengths) {
  for (int count = 4; count <= 120; ++count) {
    const std::vector<double> l = elements(count, 1, 0.01, 0.05);
    ASSERT_EQ(l.size(), static_cast<std::size_t>(count));
    EXPECT_NEAR(l.front(), 0.01, 1e-6) << count;
    EXPECT_NEAR(l.back(), 0.05, 1e-6) << count;
    EXPECT_NEAR(sum(l), 1, 1e-9) << count;
  }
}

TEST(LogSpacing, EndsThatSuitTheNumberGiveOneRatio) {
  // 1 + q + ... + q^9 = 35.9 with q = 1.283..., whose ninth power is the ratio of the ends.
  const double q = std::pow(10, 1.0 / 9);
  double length = 0;
  for (int k = 0; k < 10; ++k) length += 0.01 * std::pow(q, k);
  const std::vector<double> l = elements(10, length, 0.01, 0.1);
  for (int k = 1; k < 10; ++k) EXPECT_NEAR(l[k] / l[k - 1], q, 1e-6);
}

TEST(LogSpacing, LengthsRiseOrFallToTheMiddleAndMirror) {
  for (const int count : {12, 24, 40}) {
    const std::vector<double> l = elements(count, 1, 0.3, 0.3);
    for (int k = 0; k < count; ++k) EXPECT_NEAR(l[k], l[count - 1 - k], 1e-9);
    for (int k = 1; k < count / 2; ++k) EXPECT_LT(l[k], l[k - 1]);
  }
  const std::vector<double> forwards = elements(20, 2, 0.01, 0.2);
  std::vector<double> backwards = elements(20, 2, 0.2, 0.01);
  std::ranges::reverse(backwards);
  for (int k = 0; k < 20; ++k) EXPECT_NEAR(forwards[k], backwards[k], 1e-9);
}

TEST(LogSpacing, WithOneEndElementsGrowByOneRatio) {
  const std::vector<double> l = elements(10, 1, 0.02, 0);
  EXPECT_NEAR(l[0], 0.02, 1e-9);
  for (int k = 2; k < 10; ++k) EXPECT_NEAR(l[k] / l[k - 1], l[1] / l[0], 1e-9);
  std::vector<double> mirrored = elements(10, 1, 0, 0.02);
  std::ranges::reverse(mirrored);
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(l[k], mirrored[k], 1e-12);
  EXPECT_NEAR(elements(50, 1, 0.02, 0).back(), 0.02, 1e-9) << "equal elements";
}

TEST(LogSpacing, EndsThatLeaveNoRoomAreReduced) {
  EXPECT_EQ(elements(1, 2, 0.1, 0.1), (std::vector<double>{2}));
  EXPECT_NEAR(elements(2, 1, 0.1, 0.3)[0], 0.25, 1e-9);
  const std::vector<double> l = elements(5, 1, 2, 1);
  EXPECT_NEAR(l.front(), 0.6, 1e-6);
  EXPECT_NEAR(l.back(), 0.3, 1e-6);
  for (const double length : elements(4, 1, 0, 0)) EXPECT_NEAR(length, 0.25, 1e-12);
}

TEST(LogSpacing, TheLocalLengthIsThatOfAnElementThere) {
  const LogSpacing spacing(100, 1, 0.002, 0);
  const double ratio = spacing.element_length(0.5) / spacing.element_length(0);
  EXPECT_GT(ratio, 1);
  EXPECT_NEAR(spacing.element_length(0), 0.002, 5e-5);
  EXPECT_EQ(spacing.element_length(2), spacing.element_length(1));
}

}  // namespace
}  // namespace quadrille::prescribe
