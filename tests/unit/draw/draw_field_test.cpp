#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "base/error.hpp"
#include "square_samples.hpp"

namespace quadrille::draw {
namespace {

TEST(DrawField, FieldShowsCellsAndBothZeroContours) {
  for (const char* show : {"psi", "u", "v"}) {
    DrawOptions options;
    options.show = show;
    const std::string svg = draw_stage(linear_field(), options);
    expect_sound(svg);
    EXPECT_GT(count(svg, "<path fill="), 10) << show;
    EXPECT_GE(count(svg, "class=\"zero-u\""), 1) << show;
    EXPECT_GE(count(svg, "class=\"zero-v\""), 1) << show;
    EXPECT_EQ(svg, draw_stage(linear_field(), options));
  }
}

TEST(DrawField, OrderMapShowsEveryElement) {
  DrawOptions options;
  options.show = "order";
  const std::string svg = draw_stage(linear_field(), options);
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"elem-"), 2);
}

TEST(DrawField, UnknownQuantityIsAUsageError) {
  DrawOptions options;
  options.show = "w";
  EXPECT_THROW(draw_stage(linear_field(), options), UsageError);
}

TEST(DrawField, AnAlignedFieldShowsThePrescribedDirectionsInsideTheFace) {
  Field field = linear_field();
  EXPECT_EQ(count(draw_stage(field, {}), "class=\"prescribed\""), 0);
  field.alignment = {{{0.25, 0.5}, 0.1, 1, 0.3},
                     {{0.25, 0.5}, 0.1, 0.5, 1},
                     {{0.75, 0.5}, 0.1, 1, 0.3},
                     {{0.5, 0.25}, 0.1, 1e-3, 0.3},
                     {{2, 0.5}, 0.1, 1, 0.3}};
  const std::string svg = draw_stage(field, {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "class=\"prescribed\""), 2) << "one path, and that of the legend";
  const std::size_t begin = svg.find("class=\"prescribed\"");
  EXPECT_EQ(count(svg.substr(begin, svg.find("/>", begin) - begin), "M"), 2) << "one in each place, none outside";
}

TEST(DrawField, PhaseFormShowsTheNodesAskedForAndNoZeroContours) {
  for (const char* show : {"psi", "u", "v", "order"}) {
    DrawOptions options = thousand_pixels_a_unit();
    options.show = show;
    const std::string svg = draw_stage(phase_field(), options);
    expect_sound(svg);
    EXPECT_EQ(count(svg, ">Phase form: "), 2) << "the title and what is seen of it; " << show;
    EXPECT_EQ(count(svg, "class=\"zero-"), 0);
    EXPECT_EQ(count(svg, "6 coefficients, 1 node asked for, 1 boundary node, 1 corner valence<"), 1);
    EXPECT_EQ(count(svg, "<title>node of valence 3 asked for at (0.5, 0.5)<"), 1);
    EXPECT_EQ(count(svg, "<title>boundary node of valence 3 asked for on curve 1<"), 1);
  }
}

TEST(DrawField, FieldsAndPointsOfRegions) {
  const Field field = samples::two_regions_field(), phase = samples::two_regions_phase_field();
  for (const std::string show : {"psi", "u", "order"}) {
    DrawOptions options;
    options.show = show;
    for (const std::string& svg : {draw_stage(field, options), draw_stage(phase, options)}) {
      expect_sound(svg);
      EXPECT_EQ(count(svg, "class=\"interface\""), 2);
      EXPECT_EQ(count(svg, ", 2 regions"), 1);
    }
  }
  EXPECT_EQ(count(draw_stage(phase, {}), "24 coefficients, 1 node asked for, 8 corner valences"), 1);
  const std::string points = draw_points(samples::two_regions_points(), &field, {});
  expect_sound(points);
  EXPECT_EQ(count(points, "class=\"corner\""), 9) << "8 and the legend";
  EXPECT_EQ(count(points, "class=\"interface\""), 2);
}

}  // namespace
}  // namespace quadrille::draw
