#include "sizing/element_limit.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "refine/refine.hpp"

namespace quadrille::sizing {
namespace {

std::string message_with(const refine::RefineOptions& options) {
  try {
    refined(hand_made::unit_square(), options);
  } catch (const TooManyElements& e) {
    return e.what();
  }
  return "";
}

TEST(ElementLimit, MoreElementsAreRefusedWithAnEstimateAndARemedy) {
  refine::RefineOptions options{1e-4, 1};
  EXPECT_EQ(
      message_with(options),
      "sizes require about 100000000 quads, more than --max-elements 1000000: raise --size by a factor of 10, or raise "
      "--max-elements");
}

TEST(ElementLimit, CountsAreNamedWhereTheyAreTheCause) {
  refine::RefineOptions options{0.1, 1};
  options.counts = {{0, 2000000}};
  EXPECT_EQ(message_with(options),
            "counts require about 20000000 quads, more than --max-elements 1000000: lower --count, or raise "
            "--max-elements");
  options.size = 1e-7;
  EXPECT_EQ(message_with(options),
            "sizes and counts require about 2e+13 quads, more than --max-elements 1000000: raise --size by a factor of "
            "4.47e+03, or raise --max-elements");
}

TEST(ElementLimit, TheEstimateIsReportedAlsoIfItIsRefused) {
  const auto estimate_of = [](double size) {
    Report report;
    const BlockLayout layout = block::extract_blocks(hand_made::unit_square(), report);
    try {
      refine::refine(layout, {size, 1}, report);
    } catch (const TooManyElements&) {
    }
    for (const auto& [key, value] : report.entries())
      if (key == "estimated_quads") return std::get<long long>(value);
    return -1LL;
  };
  EXPECT_EQ(estimate_of(0.1), 100);
  EXPECT_EQ(estimate_of(1e-4), 100000000);
  EXPECT_EQ(estimate_of(1e-300), 1000000000000000000);
}

TEST(ElementLimit, TheAreaRefusesMoreThanFourTimesTheLimit) {
  EXPECT_NO_THROW(require_area_within(1, 0.1, {25, 1}));
  EXPECT_THROW(require_area_within(1.001, 0.1, {25, 1}), TooManyElements);
}

TEST(ElementLimit, ItIsTheGreatestNumberThatIsAccepted) {
  refine::RefineOptions options{0.1, 2};
  options.max_elements = 100;
  EXPECT_EQ(message_with(options), "");
  options.max_elements = 99;
  EXPECT_NE(message_with(options).find("about 100 quads, more than --max-elements 99"), std::string::npos);
}

TEST(ElementLimit, ManyNodesAreRefusedToo) {
  refine::RefineOptions options{1e-3 / 0.9, 20};
  options.max_elements = 100000000;
  EXPECT_NE(message_with(options).find("quads of order 20, with more than 1e8 nodes"), std::string::npos);
}

TEST(ElementLimit, TheDividedArcsCountExactly) {
  Report report;
  const BlockLayout layout = block::extract_blocks(hand_made::unit_square(), report);
  ArcDivisions divisions(layout.arcs.size());
  for (ArcDivision& division : divisions) division.ends = {0, 0.25, 0.5, 1};
  EXPECT_NO_THROW(require_divided_within(layout, divisions, {9, 1}));
  EXPECT_THROW(require_divided_within(layout, divisions, {8, 1}), TooManyElements);
}

}  // namespace
}  // namespace quadrille::sizing
