#include "refine/refine_options.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::refine {
namespace {

std::string refusal(const std::function<void(RefineOptions&)>& change) {
  RefineOptions options;
  change(options);
  return message_of<UsageError>([&] { options.validate(); });
}

TEST(RefineOptions, IntervalsEndAtTheirLimits) {
  EXPECT_EQ(refusal([](RefineOptions&) {}), "");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.order = 0; }), "--order must lie in 1..20");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.order = 21; }), "--order must lie in 1..20");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.order = 20; }), "");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.size = -1e-9; }), "--size must not be negative");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.levels = 11; }), "--refine must lie in 0..10");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.relax_sweeps = 1001; }), "--relax-sweeps must lie in 0..1000");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.max_elements = 0; }), "--max-elements must be at least 1");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.min_scaled_jacobian = 1; }), "");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.min_scaled_jacobian = 1.01; }), "--min-scaled-jacobian must lie in 0..1");
}

TEST(RefineOptions, ZeroIsNoLimitOfRatios) {
  for (const double ratio : {0.0, 1.0, 5.0}) {
    EXPECT_EQ(refusal([&](RefineOptions& o) { o.target_edge_ratio = o.max_edge_ratio = ratio; }), "");
  }
  EXPECT_EQ(refusal([](RefineOptions& o) { o.target_edge_ratio = 0.5; }),
            "--target-edge-ratio must be 0 or at least 1");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.max_edge_ratio = 0.5; }), "--max-edge-ratio must be 0 or at least 1");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.target_growth = 1; }), "--target-growth must be 0 or greater than 1");
  EXPECT_EQ(refusal([](RefineOptions& o) { o.target_growth = 0; }), "");
}

TEST(RefineOptions, NumbersThatAreNoneAreRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (double RefineOptions::*member :
       {&RefineOptions::geometry_tol, &RefineOptions::min_scaled_jacobian, &RefineOptions::target_edge_ratio,
        &RefineOptions::target_growth, &RefineOptions::max_edge_ratio, &RefineOptions::size})
    EXPECT_NE(refusal([&](RefineOptions& o) { o.*member = nan; }), "");
}

TEST(RefineOptions, ElementsOfEqualLengthNeedVerticesThatMove) {
  const auto even = [](RefineOptions& o) { o.boundary_counts = {{"wall", 8, true}}; };
  EXPECT_EQ(refusal(even), "");
  const std::string immobile =
      "--count wall=8,even: vertices have to move for elements of equal length: leave out --relax none";
  EXPECT_EQ(refusal([&](RefineOptions& o) { even(o), o.relax = Relax::none; }), immobile);
  EXPECT_EQ(refusal([&](RefineOptions& o) { even(o), o.relax_sweeps = 0; }), immobile);
  EXPECT_EQ(refusal([&](RefineOptions& o) { even(o), o.blocks = {0}; }),
            "--count wall=8,even and --blocks exclude each other: with --blocks no vertex moves");
}

TEST(ParseRelax, NamesAGoal) {
  EXPECT_EQ(parse_relax("shape"), Relax::shape);
  EXPECT_EQ(message_of<UsageError>([] { parse_relax("fast"); }), "--relax: 'fast' is not one of size, shape, none");
  EXPECT_EQ(message_of<UsageError>([] { parse_relax("20"); }), "--relax 20 is now --relax shape --relax-sweeps 20");
}

TEST(DefaultGeometryTol, FallsWithTheOrder) {
  for (int order = 1; order < 4; ++order) EXPECT_GT(default_geometry_tol(order), default_geometry_tol(order + 1));
  EXPECT_EQ(default_geometry_tol(20), default_geometry_tol(4));
}

}  // namespace
}  // namespace quadrille::refine
