#include "regions/region_work.hpp"

#include <gtest/gtest.h>

#include "../regions/faces_of_regions.hpp"

namespace quadrille::regions {
namespace {

using testing_faces::disc_in_square;

TEST(RegionWork, ProgressCountsTheRegionsThatAreDone) {
  Progress progress;
  Report report(&progress);
  std::vector<long long> done;
  for_each_region(disc_in_square(), 1, report, [&](int, int, Report&) {
    const auto counts = progress.counts().value();
    ASSERT_EQ(counts.size(), 1U);
    EXPECT_STREQ(counts[0].name, "regions");
    EXPECT_EQ(counts[0].total, 2);
    done.push_back(counts[0].done);
  });
  EXPECT_EQ(done, (std::vector<long long>{0, 1}));
  EXPECT_TRUE(progress.counts().value().empty());
}

}  // namespace
}  // namespace quadrille::regions
