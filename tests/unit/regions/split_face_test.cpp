#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "../region_samples.hpp"
#include "faces_of_regions.hpp"
#include "regions/split.hpp"

namespace quadrille::regions {
namespace {

TEST(SplitFace, AFaceOfOneRegionIsItself) {
  CadFace face = samples::face();
  face.diameter = 7;  // of the CAD file: it is not measured again
  const std::vector<CadFace> parts = split(face);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].diameter, 7);
  EXPECT_EQ(parts[0].name, "square");
}

TEST(SplitFace, CurvesOfARegionHaveNumbersFromZeroOn) {
  const CadFace whole = samples::two_regions_face();
  const std::vector<CadFace> parts = split(whole);
  ASSERT_EQ(parts.size(), 2u);
  for (const int r : {0, 1}) {
    EXPECT_EQ(parts[r].name, whole.region_names[r]);
    EXPECT_EQ(parts[r].num_regions(), 1);
    EXPECT_EQ(parts[r].loop_offsets, (std::vector<int>{0, 4}));
    EXPECT_EQ(parts[r].curve_cad_edges, (std::vector<int>{4 * r, 4 * r + 1, 4 * r + 2, 4 * r + 3}));
    EXPECT_EQ(parts[r].joints[0].position, whole.joints[4 * r].position);
    EXPECT_NEAR(parts[r].diameter, std::sqrt(2.0), 1e-12);
    EXPECT_TRUE(parts[r].periodic_pairs.empty()) << "regions are joined before their sides are";
  }
  EXPECT_EQ(parts[0].unnamed_curves, std::vector<int>{1});
  EXPECT_EQ(parts[1].unnamed_curves, std::vector<int>{3});
}

/// Both sides of a crack belong to one region; those of its interface do not.
TEST(SplitFace, CracksStayInTheirRegion) {
  CadFace whole = samples::two_regions_face();
  whole.curves.push_back(samples::line({1.25, 0.5}, {1.75, 0.5}));
  whole.curves.push_back(samples::line({1.75, 0.5}, {1.25, 0.5}));
  for (const double angle : {0.0, samples::pi}) {
    whole.joints.push_back(
        {whole.curves[angle == 0 ? 8 : 9].poles.front(), angle - samples::pi, angle, 2 * samples::pi});
    whole.curve_names.emplace_back("crack");
    whole.curve_cad_edges.push_back(8);
  }
  whole.loop_offsets.push_back(10);
  whole.region_loops = {0, 1, 3};
  whole.partners.insert(whole.partners.end(), {9, 8});
  const std::vector<CadFace> parts = split(whole);
  EXPECT_TRUE(parts[0].partners.empty());
  EXPECT_EQ(parts[1].partners, (std::vector<int>{-1, -1, -1, -1, 5, 4}));
  EXPECT_EQ(parts[1].loop_offsets, (std::vector<int>{0, 4, 6}));
}

TEST(SplitFace, CurvesInSpaceAreThoseOfTheRegion) {
  CadFace whole = samples::two_regions_face();
  auto chart = std::make_shared<Chart>();
  for (int c = 0; c < 8; ++c)
    chart->space_curves.push_back({1, {0, 0, 1, 1}, {{1.0 * c, 0, 0}, {0, 1.0 * c, 0}}, {1, 1}});
  whole.chart = chart;
  const std::vector<CadFace> parts = split(whole);
  ASSERT_EQ(parts[1].chart->space_curves.size(), 4u);
  EXPECT_EQ(parts[1].chart->space_curves[2].poles[0].x, 6);
  EXPECT_EQ(whole.chart->space_curves.size(), 8u) << "that of the whole stays";
}

}  // namespace
}  // namespace quadrille::regions
