#include "simplify/chord_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../support/grid_layout.hpp"
#include "../support/hall.hpp"
#include "../support/snail.hpp"
#include "../support/square_field.hpp"
#include "base/tolerance.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::simplify {
namespace {

/// Two columns of three unit squares: no line in it has a fixed node, so that strips are collapsed onto the boundary.
struct Grid : testing::Test {
  Field field = interpolated_field(square_mesh({-4, -4}, 8, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  graph::Subdivision subdivision{grid_layout(2, 3)};
  BlendOptions options{1, 1e-9};

  /// The arc between two grid points.
  int arc(Vec2 a, Vec2 b) const {
    const ArcGraph& g = subdivision.graph();
    for (int i = 0; i < subdivision.arc_bound(); ++i) {
      const Vec2 from = g.nodes[g.arcs[i].from].position, to = g.nodes[g.arcs[i].to].position;
      if (std::min(distance(from, a) + distance(to, b), distance(from, b) + distance(to, a)) < 1e-9) return i;
    }
    ADD_FAILURE() << "no such arc";
    return -1;
  }
  graph::ChordStrip column(int i) const { return graph::strip_through(subdivision, arc({i + 0.0, 0}, {i + 1.0, 0})); }
  graph::ChordStrip row(int j) const { return graph::strip_through(subdivision, arc({0, j + 0.0}, {0, j + 1.0})); }

  struct Trial {
    graph::Subdivision subdivision;
    ArcChanges changes;
    double deviation = 0;
  };
  std::optional<Trial> collapse(const std::vector<graph::ChordStrip>& strips) const {
    const auto blends = blends_of_group(evaluator, subdivision, strips, options);
    if (!blends) return std::nullopt;
    Trial trial{subdivision, {}, greatest_deviation(*blends)};
    const auto changes = collapse_group(trial.subdivision, strips, *blends);
    if (!changes) return std::nullopt;
    trial.changes = *changes;
    trial.subdivision.compact();
    return trial;
  }
  static void expect_blocks(const std::optional<Trial>& trial, int num) {
    ASSERT_TRUE(trial);
    EXPECT_EQ(trial->subdivision.num_faces(), num);
    EXPECT_TRUE(graph::faces_without_four_corners(trial->subdivision).empty());
    EXPECT_EQ(trial->deviation, 0);  // nothing is blended
  }
};

TEST_F(Grid, NoStripIsNoChange) {
  const auto trial = collapse({});
  expect_blocks(trial, 6);
  for (int a = 0; a < subdivision.arc_bound(); ++a) EXPECT_EQ(trial->changes.now(a), a);
  EXPECT_TRUE(trial->changes.changed.empty());
}

TEST_F(Grid, AStripIsCollapsedOntoTheBoundary) {
  const auto trial = collapse({column(0)});
  expect_blocks(trial, 3);
  for (int j = 0; j < 4; ++j) EXPECT_EQ(trial->changes.now(arc({0, j + 0.0}, {1, j + 0.0})), -1) << "a rung";
  for (int j = 0; j < 3; ++j)
    EXPECT_EQ(trial->changes.now(arc({0, j + 0.0}, {0, j + 1.0})), trial->changes.now(arc({1, j + 0.0}, {1, j + 1.0})));
}

TEST_F(Grid, ArcsThatBecameLongerAreMarked) {
  const auto trial = collapse({column(0)});
  ASSERT_TRUE(trial);
  std::set<int> longer;
  for (int j = 0; j < 4; ++j) longer.insert(arc({1, j + 0.0}, {2, j + 0.0}));
  EXPECT_EQ(trial->changes.changed, longer);
}

TEST_F(Grid, StripsSideBySideWithACommonRailAreNotCollapsedTogether) {
  EXPECT_FALSE(collapse({column(0), column(1)}));
  EXPECT_FALSE(collapse({row(0), row(1)}));
  EXPECT_FALSE(collapse({column(0), column(0)}));
}

TEST_F(Grid, StripsWithoutACommonRailAreCollapsedTogether) {
  expect_blocks(collapse({row(0), row(2)}), 2);
  expect_blocks(collapse({row(2), row(0)}), 2);
}

TEST_F(Grid, StripsThatCrossAreCollapsedInAnyOrderToTheSame) {
  const auto a = collapse({column(0), row(0)}), b = collapse({row(0), column(0)});
  expect_blocks(a, 2);
  expect_blocks(b, 2);
  const auto places = [](const Trial& trial) {
    std::set<std::pair<double, double>> set;
    for (const GraphNode& node : trial.subdivision.graph().nodes) set.insert({node.position.x, node.position.y});
    return set;
  };
  EXPECT_EQ(places(*a), places(*b));
  EXPECT_EQ(a->changes.now(arc({1, 0}, {1, 1})), -1) << "a rung of the row, where the column collapsed first";
}

TEST_F(Grid, AStripBetweenBoundariesIsNotCollapsedNorAnyWithIt) {
  subdivision = graph::Subdivision(grid_layout(1, 3));
  EXPECT_FALSE(collapse({graph::strip_through(subdivision, arc({0, 0}, {1, 0}))}));
  EXPECT_FALSE(collapse({row(0), graph::strip_through(subdivision, arc({0, 0}, {1, 0}))}));
  expect_blocks(collapse({row(0)}), 2);
}

TEST_F(Grid, BlendsDeviateByTheGreatestOfThem) {
  const double step = 0.1;
  subdivision = hall(step).subdivision;
  const graph::ChordStrip strip = thin_strip_of_hall(subdivision, step);
  const auto trial = collapse({strip});
  ASSERT_TRUE(trial);
  EXPECT_NEAR(trial->deviation, deviation_of_hall(step), 1e-3);
  EXPECT_EQ(trial->subdivision.num_faces(), subdivision.num_faces() - 2);
  options.max_deviation = 0.9 * deviation_of_hall(step);
  EXPECT_FALSE(collapse({strip}));
}

// ---- Shortcuts of spirals

struct ShortenSnail : testing::Test {
  Field field = interpolated_field(square_mesh({-3, -3}, 6, 6), 4, [](Vec2 x) {
    const Vec2 z2{x.x * x.x - x.y * x.y, 2 * x.x * x.y};
    return Vec2{z2.x * z2.x - z2.y * z2.y, 2 * z2.x * z2.y};
  });
  field::FieldEvaluator evaluator{field};
  graph::Subdivision subdivision = snail::layout().subdivision;
  std::vector<SpiralShortcut> shortcuts = find_shortcuts(subdivision, graph::arc_lengths(subdivision.graph()));
};

TEST_F(ShortenSnail, AShortcutLeavesFewerBlocks) {
  const auto trial = shorten_group(evaluator, subdivision, shortcuts, {1, 1e-9});
  ASSERT_TRUE(trial);
  EXPECT_EQ(trial->subdivision.num_faces(), 3);
  EXPECT_NEAR(trial->deviation, snail::deviation_at_middle(), 0.02);
}

TEST_F(ShortenSnail, TwoShortcutsOfOneLineAreNone) {
  shortcuts.push_back(shortcuts.at(0));
  EXPECT_FALSE(shorten_group(evaluator, subdivision, shortcuts, {1, 1e-9}));
}

TEST_F(ShortenSnail, AShortcutThatDeviatesTooFarIsNone) {
  EXPECT_FALSE(shorten_group(evaluator, subdivision, shortcuts, {0.9 * snail::deviation_at_middle(), 1e-9}));
}

using Strips = std::vector<graph::ChordStrip>;

// Groups of all strips that can be collapsed, from scratch.
std::vector<Strips> all_groups(const graph::Subdivision& subdivision) {
  Strips strips = graph::all_strips(subdivision, graph::arc_lengths(subdivision.graph()));
  std::erase_if(strips, [&](const auto& s) { return graph::fixed_sides(subdivision, s).empty(); });
  std::stable_sort(strips.begin(), strips.end(), [](const auto& a, const auto& b) { return a.aspect() < b.aspect(); });
  std::vector<Strips> groups;
  for (graph::ChordStrip& strip : strips) {
    if (groups.empty() || strip.aspect() > groups.back().front().aspect() * (1 + tolerance::tied))
      groups.emplace_back();
    groups.back().push_back(std::move(strip));
  }
  return groups;
}

void expect_same(const Strips& a, const Strips& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].rungs, b[i].rungs);
    EXPECT_EQ(a[i].left, b[i].left);
    EXPECT_EQ(a[i].right, b[i].right);
    EXPECT_EQ(a[i].aspect(), b[i].aspect());
  }
}

// The groups that the queue returns if each is refused.
void expect_all_groups(StripQueue queue, const graph::Subdivision& subdivision) {
  for (const Strips& expected : all_groups(subdivision)) {
    const Strips group = queue.thinnest();
    expect_same(group, expected);
    if (group.empty()) return;
    queue.refuse(group);
  }
  EXPECT_TRUE(queue.thinnest().empty());
}

struct QueueOfStrips : testing::Test {
  Field field = interpolated_field(square_mesh({-4, -4}, 16, 3), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};

  // Collapses the k-th group again and again, and compares the queue with one made anew.
  void collapse_all(graph::Subdivision subdivision, std::size_t k) {
    StripQueue queue(subdivision);
    for (int round = 0; round < 20; ++round) {
      expect_all_groups(queue, subdivision);
      const std::vector<Strips> groups = all_groups(subdivision);
      if (groups.empty()) return;
      // A single strip: equal ones side by side have common rails.
      const Strips group{groups[std::min(k, groups.size() - 1)].front()};
      const auto blends = blends_of_group(evaluator, subdivision, group, {1, 1e-9});
      if (!blends) return;
      const auto changes = collapse_group(subdivision, group, *blends);
      ASSERT_TRUE(changes);
      queue.update(subdivision, *changes);
    }
  }
};

TEST_F(QueueOfStrips, HasTheGroupsOfAllStripsAfterEveryCollapse) {
  for (const std::size_t k : {0u, 1u, 5u}) {
    collapse_all(graph::Subdivision(grid_layout(5, 3)), k);
    collapse_all(graph::Subdivision(grid_layout(2, 6)), k);
    collapse_all(hall(0.1).subdivision, k);
  }
}

TEST_F(QueueOfStrips, ARefusedGroupReturnsWhenAStripOfItHasChanged) {
  graph::Subdivision subdivision(grid_layout(4, 3));
  StripQueue queue(subdivision);
  Strips refused;
  for (Strips group = queue.thinnest(); !group.empty(); group = queue.thinnest()) {
    queue.refuse(group);
    refused = group;
  }
  ASSERT_FALSE(refused.empty());
  const Strips column{refused.front()};
  const auto changes = collapse_group(subdivision, column, *blends_of_group(evaluator, subdivision, column, {1, 1e-9}));
  ASSERT_TRUE(changes);
  queue.update(subdivision, *changes);
  EXPECT_FALSE(queue.thinnest().empty());
}

}  // namespace
}  // namespace quadrille::simplify
