#include "simplify/strip_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/grid_layout.hpp"
#include "../support/hall.hpp"
#include "../support/square_field.hpp"
#include "simplify/chord_group.hpp"

namespace quadrille::simplify {
namespace {

using Strips = std::vector<graph::ChordStrip>;

// Groups of all strips that can be collapsed, from scratch.
std::vector<Strips> all_groups(const graph::Subdivision& subdivision) {
  Strips strips = graph::all_strips(subdivision, graph::arc_lengths(subdivision.graph()));
  std::erase_if(strips, [&](const auto& s) { return graph::fixed_sides(subdivision, s).empty(); });
  std::stable_sort(strips.begin(), strips.end(), [](const auto& a, const auto& b) { return a.aspect() < b.aspect(); });
  std::vector<Strips> groups;
  for (graph::ChordStrip& strip : strips) {
    if (groups.empty() || strip.aspect() > groups.back().front().aspect() * (1 + equal_aspect)) groups.emplace_back();
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
