#include "base/progress.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "base/parallel.hpp"

namespace quadrille {
namespace {

std::vector<Progress::Count> counts(const Progress& progress) {
  const auto counts = progress.counts();
  EXPECT_TRUE(counts);
  return counts.value_or(std::vector<Progress::Count>{});
}

TEST(Progress, HasNoPartsAtFirstAndAtTheEnd) {
  Progress progress;
  EXPECT_TRUE(counts(progress).empty());
  { const Progress::Part part(&progress, "elements", 3); }
  EXPECT_TRUE(counts(progress).empty());
}

TEST(Progress, CountsTheStepsOfEachPart) {
  Progress progress;
  const Progress::Part outer(&progress, "solutions", 20, Progress::Total::bound);
  outer.advance(2);
  for (int repeated = 0; repeated < 2; ++repeated) {
    const Progress::Part inner(&progress, "elements", 8);
    EXPECT_EQ(counts(progress)[1].done, 0);
    inner.advance();
    inner.advance(4);
    ASSERT_EQ(counts(progress).size(), 2u);
    EXPECT_STREQ(counts(progress)[1].name, "elements");
    EXPECT_EQ(counts(progress)[1].done, 5);
    EXPECT_EQ(counts(progress)[1].total, 8);
    EXPECT_EQ(counts(progress)[1].kind, Progress::Total::exact);
  }
  ASSERT_EQ(counts(progress).size(), 1u);
  EXPECT_EQ(counts(progress)[0].done, 2);
  EXPECT_EQ(counts(progress)[0].kind, Progress::Total::bound);
}

TEST(Progress, ATotalOfZeroIsUnknown) {
  Progress progress;
  const Progress::Part part(&progress, "choices");
  EXPECT_EQ(counts(progress)[0].kind, Progress::Total::unknown);
}

TEST(Progress, WithoutAProgressNothingIsCounted) {
  Progress progress;
  const Progress::Part counted(&progress, "solutions", 2);
  const Progress::Part part(nullptr, "elements", 3);
  part.advance();
  ASSERT_EQ(counts(progress).size(), 1u) << "the part belongs to no progress";
  EXPECT_EQ(counts(progress)[0].done, 0);
}

TEST(Progress, PartsThatAreTooDeepAreNotCountedAndDisturbNoOther) {
  Progress progress;
  const std::function<void(int)> nested = [&](int depth) {
    const Progress::Part part(&progress, "nested", 10);
    part.advance(depth);
    if (depth < 9) nested(depth + 1);
    const std::vector<Progress::Count> now = counts(progress);
    EXPECT_LE(now.size(), static_cast<std::size_t>(depth));
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_EQ(now[i].done, i + 1);
  };
  nested(1);
  EXPECT_TRUE(counts(progress).empty());
}

TEST(Progress, APartEndsWithAnException) {
  Progress progress;
  try {
    const Progress::Part part(&progress, "elements", 3);
    throw 1;
  } catch (int) {
  }
  EXPECT_TRUE(counts(progress).empty());
}

TEST(Progress, IsConsistentForAThreadThatReadsItMeanwhile) {
  Progress progress;
  std::atomic<bool> is_over = false;
  std::jthread reader([&] {
    while (!is_over) {
      const auto seen = progress.counts();
      if (!seen || seen->empty()) continue;
      const Progress::Count& count = seen->front();
      EXPECT_EQ(count.total, count.name[0] == 'f' ? 5 : 7);
      EXPECT_LE(count.done, count.total);
    }
  });
  for (int i = 0; i < 2000; ++i) {
    const Progress::Part part(&progress, i % 2 == 0 ? "five" : "seven", i % 2 == 0 ? 5 : 7);
    parallel_for(i % 2 == 0 ? 5 : 7, 1, [&](int) { part.advance(); });
  }
  is_over = true;
}

TEST(Progress, IsCountedByAllThreads) {
  Progress progress;
  const Progress::Part part(&progress, "elements", 1000);
  parallel_for(1000, 4, [&](int) { part.advance(); });
  EXPECT_EQ(counts(progress)[0].done, 1000);
}

}  // namespace
}  // namespace quadrille
