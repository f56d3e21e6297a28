#include "chain/budget.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "temporary_folder.hpp"

namespace quadrille::chain {
namespace {

using Clock = Budget::Clock;

template <class Parse>
std::string refusal(Parse parse, const std::string& text) {
  try {
    parse(text);
  } catch (const UsageError& e) {
    return e.what();
  }
  return {};
}

TEST(Limits, sizes_have_units_of_powers_of_1024) {
  EXPECT_EQ(parse_max_memory("1000"), 1000);
  EXPECT_EQ(parse_max_memory("2G"), std::size_t{2} << 30);
  EXPECT_EQ(parse_max_memory("500m"), std::size_t{500} << 20);
  EXPECT_EQ(parse_max_memory("1.5K"), 1536);
  EXPECT_EQ(parse_max_memory("1T"), std::size_t{1} << 40);
  EXPECT_GT(parse_max_memory("1e200T"), std::size_t{1} << 60);
  EXPECT_EQ(parse_max_seconds("1e-1"), 0.1);
}

TEST(Limits, others_are_refused) {
  for (const std::string text : {"", "G", "2GB", "0", "-1M", "inf", "nan", "none", "1e999"}) {
    EXPECT_NE(refusal(parse_max_seconds, text), "") << text;
    EXPECT_NE(refusal(parse_max_memory, text), "") << text;
  }
  EXPECT_EQ(refusal(parse_max_seconds, "x"), "--max-seconds: 'x' is not a number");
  EXPECT_EQ(refusal(parse_max_seconds, "0"), "--max-seconds: 0 is outside its interval (above 0)");
  EXPECT_EQ(refusal(parse_max_memory, "2GB"), "--max-memory: '2GB' is not a size");
  EXPECT_EQ(refusal(parse_max_memory, "-1M"), "--max-memory: -1 is outside its interval (above 0)");
}

TEST(Limits, sizes_are_printed_with_at_most_four_digits) {
  EXPECT_EQ(size_text(2048), "2K");
  EXPECT_EQ(size_text(std::size_t{9999} << 10), "9999K");
  EXPECT_EQ(size_text(std::size_t{10000} << 10), "10M");
  EXPECT_EQ(size_text(std::size_t{500} << 20), "500M");
  EXPECT_EQ(size_text(std::size_t{3} << 40), "3072G");
}

TEST(Budget, keeps_a_quarter_of_the_seconds_and_more_if_the_triangles_took_long) {
  const auto limits = [](Share share, Used triangles) {
    const Used used = Budget({.seconds = 8}, Clock::now(), {triangles, {2, 4}}).limits_of(share);
    return std::pair(used.cpu_seconds, used.wall_seconds);
  };
  EXPECT_EQ(limits(Share::all, {1, 3}), std::pair(8.0, 8.0));
  EXPECT_EQ(limits(Share::most, {0.1, 0.2}), std::pair(6.0, 6.0));
  EXPECT_EQ(limits(Share::most, {1, 1.5}), std::pair(3.0, 0.5));
}

TEST(Budget, names_the_limit_that_is_exceeded) {
  EXPECT_EQ(Budget().reason_to_stop(Share::all, nullptr), std::nullopt);
  Budget cpu({.seconds = 1});
  EXPECT_EQ(cpu.reason_to_stop(Share::all, nullptr), std::nullopt);
  cpu.add_run({1, 0}), cpu.add_run({0.5, 0});
  EXPECT_EQ(cpu.reason_to_stop(Share::all, nullptr),
            "not started after 1.50 s of CPU time of all stages: --max-seconds is 1");
  const Budget elapsed({.seconds = 1800}, Clock::now() - std::chrono::hours(1));
  const std::string reason = elapsed.reason_to_stop(Share::most, nullptr).value_or("");
  EXPECT_TRUE(matches(reason,
                      "not started after 36..\\... s of all stages: --max-seconds is 1800, and the rest is kept for "
                      "quads without a field"))
      << reason;
}

TEST(Budget, counts_helpers_but_not_as_the_triangles) {
  Budget budget({.seconds = 8});
  budget.add_helper({2, 2}), budget.add_run({0.1, 0.1});
  EXPECT_EQ(budget.limits_of(Share::most).cpu_seconds, 6.0);
  EXPECT_EQ(budget.reason_to_stop(Share::all, nullptr), std::nullopt);
  budget.add_helper({6, 6});
  EXPECT_EQ(budget.reason_to_stop(Share::all, nullptr),
            "not started after 8.10 s of CPU time of all stages: --max-seconds is 8");
}

// Nine seconds for a chart and its triangles, eight of them for the chart.
TEST(Budget, keeps_no_more_for_a_slow_chart) {
  Budget budget({.seconds = 80});
  budget.add_run({9, 9});
  EXPECT_EQ(budget.limits_of(Share::most).cpu_seconds, 35.0);
  budget.move_to_helper({8, 8});
  EXPECT_EQ(budget.limits_of(Share::most).cpu_seconds, 60.0);
  EXPECT_EQ(budget.limits_of(Share::most).wall_seconds, 60.0);
  budget.add_run({71.5, 0});
  EXPECT_EQ(budget.reason_to_stop(Share::all, nullptr),
            "not started after 80.50 s of CPU time of all stages: --max-seconds is 80");
}

TEST(Budget, is_limited_by_seconds_or_memory) {
  EXPECT_FALSE(Budget().is_limited());
  EXPECT_TRUE(Budget({.seconds = 1}).is_limited());
  EXPECT_TRUE(Budget({.memory = 1}).is_limited());
}

}  // namespace
}  // namespace quadrille::chain
