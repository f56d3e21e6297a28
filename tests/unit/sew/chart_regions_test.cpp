#include "sew/chart_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "charted_square.hpp"
#include "model/interfaces.hpp"

namespace quadrille::sew {
namespace {

using namespace testing_charts;
using testing_regions::circle;

CadFace divided(const std::vector<ChartCurve>& curves, const std::vector<int>& curve_faces = {0, 0, 0, 0}) {
  Report report;
  const ChartRegionOptions options{"x.step", 1e-5, 0.01, {"one", "two"}, curve_faces};
  return divided_chart(charted_square(), curves, options, report);
}

/// Both sides of each inner curve are the same, in the chart and in space, and curves of loops meet in space.
void expect_sound(const CadFace& face) {
  for (int c = 0; c < face.num_curves(); ++c) {
    const SpaceCurve &space = face.chart->space_curves[c], &next = face.chart->space_curves[face.next_in_loop(c)];
    EXPECT_EQ(space.poles.back(), next.poles.front());
    EXPECT_EQ(face.curves[c].poles.back(), face.curves[face.next_in_loop(c)].poles.front());
    EXPECT_EQ(space.begin(), face.curves[c].begin());
    EXPECT_EQ(space.end(), face.curves[c].end());
    const int other = face.partners[c];
    if (other < 0) continue;
    EXPECT_EQ(face.partners[other], c);
    const SpaceCurve& back = face.chart->space_curves[other];
    EXPECT_TRUE(std::equal(space.poles.begin(), space.poles.end(), back.poles.rbegin(), back.poles.rend()));
  }
}

int num_sides(const CadFace& face) {
  return static_cast<int>(std::count_if(face.partners.begin(), face.partners.end(), [](int p) { return p >= 0; }));
}

TEST(ChartRegions, a_crack_inside_is_a_loop_with_open_tips) {
  const CadFace face = divided({line({0.5, 1}, {1.5, 1})});
  expect_sound(face);
  EXPECT_EQ(face.num_regions(), 1);
  EXPECT_EQ(face.name, "one");
  EXPECT_EQ(face.num_loops(), 2);
  EXPECT_EQ(num_sides(face), 2);
  EXPECT_TRUE(face.is_slit_loop(1));
  EXPECT_EQ(face.joints[4].interior_angle, 2 * pi);
}

TEST(ChartRegions, an_end_on_the_boundary_cuts_it_and_moves_onto_it) {
  const CadFace face = divided({line({1, 4e-6}, {1, 1})});
  expect_sound(face);
  EXPECT_EQ(face.num_loops(), 1);
  EXPECT_EQ(face.num_curves(), 7);
  EXPECT_EQ(std::count_if(face.joints.begin(), face.joints.end(), [](const Joint& j) { return j.position.y == 0; }), 4);
}

TEST(ChartRegions, an_end_just_before_the_boundary_is_refused) {
  EXPECT_NE(message_of<FormatError>([] {
              divided({line({1, 1e-3}, {1, 1})});
            }).find("0.001 before edge 0"),
            std::string::npos);
}

TEST(ChartRegions, crossing_curves_are_cut_at_their_crossing) {
  const CadFace face = divided({line({0.5, 1}, {1.5, 1}), line({0.7, 0.6}, {1.3, 1.4})});
  expect_sound(face);
  EXPECT_EQ(num_sides(face), 8);
  EXPECT_EQ(face.num_regions(), 1);
}

TEST(ChartRegions, the_common_edge_of_two_faces_makes_regions_in_their_order) {
  // The lower right half is face 1.
  const CadFace face = divided({line({0, 0}, {2, 2}, {0, 1})}, {1, 1, 0, 0});
  expect_sound(face);
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(face.loop_offsets, (std::vector<int>{0, 3, 6}));
  EXPECT_EQ(face.curve_cad_edges[3], 0);
}

TEST(ChartRegions, faces_on_the_wrong_side_of_their_common_edge_overlap) {
  EXPECT_NE(message_of<FormatError>([] {
              divided({line({0, 0}, {2, 2}, {1, 0})}, {1, 1, 0, 0});
            }).find("overlap"),
            std::string::npos);
}

TEST(ChartRegions, a_closed_curve_makes_two_regions_of_one_face) {
  const CadFace face = divided({inner(circle({1, 1}, 0.4).front().curve, {-1, -1})});
  expect_sound(face);
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"one", "one"}));
  EXPECT_EQ(num_sides(face), 2);
}

TEST(ChartRegions, a_curve_along_another_one_is_left_out) {
  const CadFace face = divided({line({0.5, 1}, {1.5, 1}), line({1.5, 1}, {0.5, 1}, {-1, -1})});
  EXPECT_EQ(num_sides(face), 2);
}

TEST(ChartRegions, a_divided_face_is_divided_again) {
  // The common edge of two faces is cut where a curve of each ends on it.
  Report report;
  const CadFace two = divided({line({0, 0}, {2, 2}, {0, 1})}, {1, 1, 0, 0});
  const ChartRegionOptions options{"x.step", 1e-5, 0.01, {"one", "two"}, curve_regions(two), 0};
  const CadFace face =
      divided_chart(two, {line({0, 1}, {1, 1}, {-1, -1}), line({1, 1}, {2, 0.8}, {-1, -1})}, options, report);
  expect_sound(face);
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"one", "one", "two", "two"}));
  EXPECT_EQ(face.num_curves(), 14);
  EXPECT_EQ(num_sides(face), 8);
  const CadFace same = divided_chart(two, {}, options, report);
  expect_sound(same);
  EXPECT_EQ(same.region_names, two.region_names);
  EXPECT_EQ(same.loop_offsets, two.loop_offsets);
  EXPECT_EQ(num_sides(same), 2);
}

TEST(ChartRegions, an_end_just_before_another_curve_stays_if_that_is_meant) {
  Report report;
  const ChartRegionOptions options{"x.step", 1e-5, 0.01, {"one"}, {0, 0, 0, 0}, 0};
  const CadFace face = divided_chart(charted_square(), {line({1, 1e-3}, {1, 1})}, options, report);
  EXPECT_EQ(face.num_loops(), 2);
}

}  // namespace
}  // namespace quadrille::sew
