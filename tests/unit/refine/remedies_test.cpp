#include "refine/remedies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "split_samples.hpp"

namespace quadrille::refine {
namespace {

/// Whether a remedy applies after `last`; the first one that does changes the settings.
bool apply(const SplitSample& sample, const SplitMesh& last, SplitSettings& settings) {
  return std::ranges::any_of(remedies(), [&](Remedy remedy) { return remedy(sample.request, last, settings); });
}

SplitMesh first_attempt(const SplitSample& sample) {
  return split(sample.request, first_settings(sample.request), nullptr);
}

/// As if no element were proved valid.
SplitMesh invalid_attempt(const SplitSample& sample) {
  SplitMesh attempt = first_attempt(sample);
  attempt.mesh.elem_jacobian_bound.assign(attempt.mesh.num_elems(), -1);
  attempt.mesh.is_valid = false;
  return attempt;
}

TEST(Remedies, NoneAppliesToAMeshWithinAllLimits) {
  const SplitSample sample(hand_made::unit_square(), {.size = 0.5, .order = 2});
  SplitSettings settings = first_settings(sample.request);
  EXPECT_FALSE(apply(sample, first_attempt(sample), settings));
}

TEST(Remedies, LinesChangeBeforeCountsAndAreRestoredWithThem) {
  RefineOptions options{.size = 0.5, .order = 2};
  const SplitSample sample(hand_made::s_bend(), options);
  const SplitMesh invalid = invalid_attempt(sample);
  SplitSettings settings = first_settings(sample.request);
  ASSERT_TRUE(settings.is_aligned);
  settings.limits_growth = true;
  EXPECT_TRUE(apply(sample, invalid, settings));
  EXPECT_TRUE(settings.is_aligned && !settings.limits_growth);
  EXPECT_TRUE(apply(sample, invalid, settings));
  EXPECT_FALSE(settings.is_aligned);
  EXPECT_EQ(settings.doublings, 0);
  EXPECT_TRUE(apply(sample, invalid, settings));
  EXPECT_TRUE(settings.is_aligned) << "smaller elements may be valid with aligned lines";
  EXPECT_EQ(settings.doublings, 1);
  EXPECT_EQ(settings.counts.size(), sample.equal.chords().size());
}

TEST(Remedies, EqualFractionsHaveTheLimitOnGrowthAgain) {
  RefineOptions options{.size = 0.5, .order = 2};
  const SeparatrixGraph square = square_with_wall(options);
  const SplitSample sample(square, options);
  SplitSettings settings = first_settings(sample.request);
  ASSERT_TRUE(settings.limits_growth);
  settings.limits_growth = false;
  settings.is_aligned = true;
  EXPECT_TRUE(apply(sample, invalid_attempt(sample), settings));
  EXPECT_TRUE(settings.limits_growth && !settings.is_aligned);
}

TEST(Remedies, CountsAreDoubledThreeTimesAndNotForAMeshThatMayBeInvalid) {
  RefineOptions options{.size = 1, .order = 2};
  const SplitSample sample(hand_made::unit_square(), options);
  const SplitMesh invalid = invalid_attempt(sample);
  SplitSettings settings = first_settings(sample.request);
  int applied = 0;
  while (apply(sample, invalid, settings)) ++applied;
  EXPECT_EQ(applied, 3);
  options.allow_invalid = true;
  const SplitSample tolerant(hand_made::unit_square(), options);
  settings = first_settings(tolerant.request);
  EXPECT_FALSE(apply(tolerant, invalid, settings));
}

TEST(Remedies, ChordsOutsideChosenBlocksGetMoreElementsFirst) {
  const SplitSample sample(hand_made::l_shape(), {.size = 0.25, .order = 1, .blocks = {0}});
  SplitSettings settings = first_settings(sample.request);
  ASSERT_FALSE(settings.counts.empty());
  EXPECT_TRUE(apply(sample, invalid_attempt(sample), settings));
  for (const sizing::ChordCount& count : settings.counts) EXPECT_EQ(count.count, 2);
  EXPECT_EQ(settings.doublings, 0);
}

TEST(Remedies, DivisionsBecomeAsMuchStricterAsTheBoundaryMissesItsTolerance) {
  const SplitSample sample(hand_made::quarter_annulus(), {.size = 2, .order = 2, .geometry_tol = 1e-3});
  SplitMesh last = first_attempt(sample);
  SplitSettings settings = first_settings(sample.request);
  EXPECT_EQ(settings.tolerance, 1e-3);
  last.distance.mesh_to_cad.distance = 2e-3;
  set_score(sample.request, last);
  EXPECT_TRUE(apply(sample, last, settings));
  EXPECT_NEAR(settings.tolerance, 0.4e-3, 1e-12);
  last.mesh.face.fit_distance = 1.5e-3;
  EXPECT_FALSE(apply(sample, last, settings)) << "splines that were replaced miss it already";
}

TEST(Remedies, ElongatedElementsAreShortenedUnlessTheirCountsArePrescribed) {
  RefineOptions options{.size = 0.25, .order = 2};
  const SplitSample sample(divided_square(1e-3, 1e-3), options);
  SplitSettings settings = first_settings(sample.request);
  SplitMesh last = first_attempt(sample);
  EXPECT_TRUE(apply(sample, last, settings));
  EXPECT_FALSE(settings.length_limits.empty());
  EXPECT_EQ(settings.max_elements, 10 * last.mesh.num_elems());
  for (int chord = 0; chord < 3; ++chord) options.counts.push_back({chord, 2});
  const SplitSample prescribed(divided_square(1e-3, 1e-3), options);
  settings = first_settings(prescribed.request);
  EXPECT_FALSE(apply(prescribed, first_attempt(prescribed), settings));
}

}  // namespace
}  // namespace quadrille::refine
