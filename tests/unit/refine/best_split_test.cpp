#include "refine/best_split.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "split_samples.hpp"

namespace quadrille::refine {
namespace {

TEST(BestSplit, OneAttemptSufficesWithinAllLimits) {
  const SplitSample sample(hand_made::unit_square(), {.size = 0.25, .order = 3});
  const BestSplit best = best_split(sample.request);
  EXPECT_EQ(best.num_splits, 1);
  EXPECT_EQ(best.split.mesh.num_elems(), 16);
  EXPECT_FALSE(mesh::is_better(mesh::MeshScore(), best.split.score));
}

TEST(BestSplit, ElementsOfAThinBlockAreShortenedUntilTheyAreWithinTheLimit) {
  const SplitSample sample(divided_square(1e-3, 0.5), {.size = 0.25, .order = 2});
  const BestSplit best = best_split(sample.request);
  EXPECT_GT(best.num_splits, 1);
  EXPECT_LE(best.num_splits, max_splits);
  EXPECT_EQ(best.split.score.elongation, 0);
  EXPECT_LE(std::ranges::max(best.split.mesh.elem_edge_ratio), 100);
}

TEST(BestSplit, AnInvalidBlockTakesNoMoreThanTheBudgetAndKeepsTheFewestUnprovedElements) {
  const SplitSample sample(folded_block(), {.size = 0.2, .order = 2});
  const BestSplit best = best_split(sample.request);
  EXPECT_GE(best.num_splits, 4) << "three doublings";
  EXPECT_LE(best.num_splits, max_splits);
  EXPECT_FALSE(best.split.mesh.is_valid);
  EXPECT_LE(best.split.score.unproved, split(sample.request, first_settings(sample.request), nullptr).score.unproved);
}

TEST(BestSplit, AnAttemptWithTooManyElementsEndsTheLoop) {
  // The first mesh has 4 + 16 elements; a hundred times shorter ones would be more than ten times as many.
  const SplitSample sample(divided_square(1e-5, 1e-5), {.size = 0.25, .order = 1});
  const BestSplit best = best_split(sample.request);
  EXPECT_EQ(best.split.mesh.num_elems(),
            split(sample.request, first_settings(sample.request), nullptr).mesh.num_elems());
  EXPECT_GT(best.split.score.elongation, 0);
  RefineOptions few{.size = 0.01, .order = 1};
  few.max_elements = 100;
  const SplitSample refused(hand_made::unit_square(), few);
  EXPECT_THROW(best_split(refused.request), ComputeError) << "of the first attempt";
}

TEST(BestSplit, TheBoundaryMeetsItsTolerance) {
  const SplitSample sample(hand_made::quarter_annulus(), {.size = 10, .order = 1, .geometry_tol = 1e-3});
  EXPECT_TRUE(best_split(sample.request).split.distance.is_within(1e-3));
}

}  // namespace
}  // namespace quadrille::refine
