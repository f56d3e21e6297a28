#include "refine/best_split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "../support/refined.hpp"
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
  SplitSettings settings;
  for (const auto& [relax, most] : {std::pair(Relax::none, 10), std::pair(Relax::size, 2)}) {
    options.relax = relax;
    const SplitSample sample(divided_square(1e-3, 1e-3), options);
    settings = first_settings(sample.request);
    SplitMesh last = first_attempt(sample);
    EXPECT_TRUE(apply(sample, last, settings));
    EXPECT_FALSE(settings.length_limits.empty());
    EXPECT_EQ(settings.max_elements, most * last.mesh.num_elems());
  }
  for (int chord = 0; chord < 3; ++chord) options.counts.push_back({chord, 2});
  const SplitSample prescribed(divided_square(1e-3, 1e-3), options);
  settings = first_settings(prescribed.request);
  EXPECT_FALSE(apply(prescribed, first_attempt(prescribed), settings));
}

TEST(BestSplit, OneAttemptSufficesWithinAllLimits) {
  const SplitSample sample(hand_made::unit_square(), {.size = 0.25, .order = 3});
  const BestSplit best = best_split(sample.request);
  EXPECT_EQ(best.num_splits, 1);
  EXPECT_EQ(best.split.mesh.num_elems(), 16);
  EXPECT_FALSE(mesh::is_better(mesh::MeshScore(), best.split.score));
}

TEST(BestSplit, ElementsOfAThinBlockAreShortenedUntilTheyAreWithinTheLimit) {
  const SplitSample sample(divided_square(1e-3, 0.5), {.size = 0.25, .order = 2, .relax = Relax::none});
  const BestSplit best = best_split(sample.request);
  EXPECT_GT(best.num_splits, 1);
  EXPECT_LE(best.num_splits, max_splits);
  EXPECT_EQ(best.split.score.elongation, 0);
  EXPECT_LE(std::ranges::max(best.split.mesh.elem_edge_ratio), 100);
}

TEST(BestSplit, ManyMoreElementsInAThinBlockWaitUntilVerticesMove) {
  const RefineOptions options{.size = 0.25, .order = 2};
  const SplitSample sample(divided_square(1e-3, 0.5), options);
  const BestSplit best = best_split(sample.request);
  EXPECT_EQ(best.num_splits, 1);
  const QuadMesh mesh = refined(divided_square(1e-3, 0.5), options);
  EXPECT_LE(std::ranges::max(mesh.elem_edge_ratio), 100);
  EXPECT_LT(mesh.num_elems(), 4 * best.split.mesh.num_elems());
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

TEST(PlaceVertices, NoneMovesWithoutLayersAndRelaxation) {
  const SplitSample sample(hand_made::s_bend(),
                           {.size = 0.45, .order = 3, .inner_edges = InnerEdges::curved, .relax = Relax::none});
  SplitMesh split = best_split(sample.request).split;
  const std::vector<Vec2> before = split.mesh.nodes;
  place_vertices(sample.request, split);
  EXPECT_EQ(split.mesh.nodes, before);
}

TEST(PlaceVertices, RelaxationNeverLowersTheLeastScaledJacobian) {
  const SplitSample sample(
      hand_made::s_bend(),
      {.size = 0.45, .order = 3, .inner_edges = InnerEdges::curved, .relax = Relax::shape, .relax_sweeps = 5});
  SplitMesh split = best_split(sample.request).split;
  const double before = std::ranges::min(split.mesh.elem_scaled_jacobian);
  place_vertices(sample.request, split);
  EXPECT_GE(std::ranges::min(split.mesh.elem_scaled_jacobian), before - 1e-6);
  EXPECT_TRUE(split.distance.is_within(sample.request.limits.distance));
}

/// The upper half of a C-grid: the wall turns by a right angle at its nose, within a tenth of its length, the far field
/// along most of its own. Lines that connect equal fractions of both are oblique to the layers.
SeparatrixGraph half_c_grid() {
  SeparatrixGraph g = hand_made::one_block(
      hand_made::face({{curve::circular_arc({0.1, 0}, 0.1, pi, pi / 2), curve::segment({0.1, 0.1}, {1.5, 0.1}),
                        curve::segment({1.5, 0.1}, {1.5, 6}), curve::segment({1.5, 6}, {1, 6}),
                        curve::circular_arc({1, 0}, 6, pi / 2, pi), curve::segment({-5, 0}, {0, 0})}},
                      9),
      {{0, 1}, {2}, {3, 4}, {5}});
  g.face.curve_names[0] = g.face.curve_names[1] = "wall";
  return g;
}

TEST(PlaceVertices, ObliqueLinesAlongAWallAreStraightened) {
  RefineOptions options{.size = 0.5, .order = 2};
  options.walls = {layers::parse_wall_spec("wall:first=0.01,layers=4,growth=1.2")};
  const SplitSample sample(half_c_grid(), options);
  SplitMesh split = best_split(sample.request).split;
  ASSERT_TRUE(split.growth);
  const mesh::MeshScore before = split.score;
  ASSERT_GT(before.skewness, 0);
  place_vertices(sample.request, split);
  EXPECT_TRUE(mesh::is_better(split.score, before));
  EXPECT_FALSE(split.lines.shifts.empty());
}

TEST(PlaceVertices, LinesThatNeedNoCorrectionStay) {
  RefineOptions options{.size = 0.2, .order = 2};
  const SeparatrixGraph square = square_with_wall(options);
  const SplitSample sample(square, options);
  SplitMesh split = best_split(sample.request).split;
  ASSERT_TRUE(split.growth);
  ASSERT_EQ(split.score.growth, 0) << "nothing is to be improved";
  const std::vector<Vec2> before = split.mesh.nodes;
  place_vertices(sample.request, split);
  EXPECT_EQ(split.mesh.nodes, before);
}

}  // namespace
}  // namespace quadrille::refine
