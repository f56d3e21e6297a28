#include "refine/split_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "split_samples.hpp"

namespace quadrille::refine {
namespace {

SplitMesh first_attempt(const SplitSample& sample) {
  return split(sample.request, first_settings(sample.request), nullptr);
}

TEST(SplitMesh, ASquareIsDividedIntoSquaresOfThePrescribedSize) {
  const SplitSample sample(hand_made::unit_square(), {.size = 0.25, .order = 2});
  const SplitMesh made = first_attempt(sample);
  EXPECT_EQ(made.mesh.num_elems(), 16);
  EXPECT_TRUE(made.mesh.is_valid);
  EXPECT_FALSE(made.walls || made.growth);
  EXPECT_LT(made.distance.worst().distance, 1e-14);
  for (const double excess : {made.score.unproved, made.score.distance, made.score.elongation, made.score.growth})
    EXPECT_EQ(excess, 0);
}

/// The splines of the face may be moved by that from the CAD curves, of which divisions leave at least a half.
TEST(SplitMesh, TheToleranceIsWhatSplinesLeaveOfIt) {
  const auto tolerance = [](double fit) {
    SeparatrixGraph square = hand_made::unit_square();
    square.face.fit_distance = fit;
    const SplitSample sample(square, {.size = 0.25, .order = 2});
    return first_settings(sample.request).tolerance;
  };
  EXPECT_DOUBLE_EQ(tolerance(0), 0.01);
  EXPECT_DOUBLE_EQ(tolerance(0.002), 0.008);
  EXPECT_DOUBLE_EQ(tolerance(0.5), 0.005);
}

TEST(SplitMesh, CountsOfSettingsComeAfterThoseOfTheUser) {
  RefineOptions options{.size = 0.25, .order = 2};
  options.counts = {{0, 3}};
  const SplitSample sample(hand_made::unit_square(), options);
  SplitSettings settings = first_settings(sample.request);
  settings.counts = {{1, 7}};
  const SplitMesh made = split(sample.request, settings, nullptr);
  EXPECT_EQ(made.mesh.num_elems(), 21);
  EXPECT_TRUE(made.plans[0].is_by_user);
  EXPECT_FALSE(made.plans[1].is_by_user);
}

TEST(SplitMesh, TooManyElementsAreRefused) {
  RefineOptions options{.size = 0.25, .order = 2};
  options.max_elements = 15;
  const SplitSample sample(hand_made::unit_square(), options);
  EXPECT_THROW(first_attempt(sample), ComputeError);
  options.max_elements = 16;
  const SplitSample enough(hand_made::unit_square(), options);
  EXPECT_EQ(first_attempt(enough).mesh.num_elems(), 16);
}

TEST(SplitMesh, FromTheLastAttemptItIsTheSame) {
  const SplitSample sample(hand_made::s_bend(), {.size = 0.3, .order = 3});
  const SplitSettings settings = first_settings(sample.request);
  const SplitMesh once = split(sample.request, settings, nullptr), again = split(sample.request, settings, &once);
  EXPECT_EQ(once.mesh.nodes, again.mesh.nodes);
  EXPECT_EQ(once.mesh.elem_jacobian_bound, again.mesh.elem_jacobian_bound);
  SplitSettings equal = settings;
  equal.is_aligned = !settings.is_aligned;
  EXPECT_EQ(split(sample.request, equal, nullptr).mesh.nodes, split(sample.request, equal, &once).mesh.nodes)
      << "with other lines nothing is taken from the last one that has changed";
}

TEST(SplitMesh, ElementsOnChordsWithLayersMayBeThin) {
  RefineOptions options{.size = 0.25, .order = 2};
  const SeparatrixGraph square = square_with_wall(options);
  const SplitSample sample(square, options);
  SplitMesh made = first_attempt(sample);
  ASSERT_TRUE(made.walls && made.growth);
  const std::vector<bool> is_layered = elements_on_layered_chords(sample.equal.blocks(), made);
  EXPECT_EQ(is_layered, std::vector<bool>(made.mesh.num_elems(), true)) << "one block";
  EXPECT_EQ(made.score.elongation, 0) << "first layers of 1e-3";
  set_prescribed_lengths(sample.request, made);
  for (const double length : made.mesh.elem_prescribed_length) EXPECT_EQ(length, 0);
}

TEST(SplitMesh, ElsewhereLengthsArePrescribed) {
  RefineOptions options{.size = 0.25, .order = 2};
  const SplitSample sample(hand_made::unit_square(), options);
  SplitMesh made = first_attempt(sample);
  EXPECT_TRUE(elements_on_layered_chords(sample.equal.blocks(), made).empty());
  set_prescribed_lengths(sample.request, made);
  EXPECT_EQ(made.mesh.elem_prescribed_length, std::vector<double>(16, 0.25));
  EXPECT_TRUE(made.mesh.elem_prescribed_stretch.empty());
}

TEST(SplitMesh, AFoldedBlockHasElementsThatAreNotProved) {
  const SplitSample sample(folded_block(), {.size = 0.5, .order = 2});
  const SplitMesh made = first_attempt(sample);
  EXPECT_FALSE(made.mesh.is_valid);
  EXPECT_GT(made.score.unproved, 0);
}

}  // namespace
}  // namespace quadrille::refine
