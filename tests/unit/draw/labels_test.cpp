#include "draw/labels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "../region_samples.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::draw {

namespace {

/// A regular polygon of radius 1; curve 0 is called `name`, the others by their numbers.
CadFace polygon(int num_sides, const std::string& name) {
  CadFace face;
  for (int k = 0; k < num_sides; ++k) {
    const auto corner = [&](int i) { return unit(2 * pi * (i % num_sides) / num_sides); };
    face.curves.push_back(curve::segment(corner(k), corner(k + 1)));
    Joint joint;
    joint.position = corner(k), joint.is_corner = k % 2 == 0;
    face.joints.push_back(joint);
    face.curve_names.push_back(k == 0 ? name : "curve_" + std::to_string(k));
    if (k > 0) face.unnamed_curves.push_back(k);
  }
  face.loop_offsets = {0, num_sides};
  face.diameter = 2;
  return face;
}

struct Label {
  double x, y, width;
  std::string text;
};

struct Drawn {
  std::vector<Label> labels;
  int num_omitted = 0, num_lines = 0, num_joints = 0;
};

Drawn drawn(const CadFace& face, int width, CurveLabels which = CurveLabels::all) {
  DrawOptions options;
  options.width = width;
  Picture picture(bounding_box(face), options, "", "");
  Drawn result;
  label_curves(picture, face, which);
  const std::string svg = picture.str();
  std::smatch found;
  if (std::regex_search(svg, found, std::regex("without room for ([0-9]+) label")))
    result.num_omitted = std::stoi(found[1]);
  const int num_legend_dots = which == CurveLabels::all ? 1 : 0;
  result.num_lines = count(svg, "class=\"edge\"");
  result.num_joints = count(svg, "class=\"dot\"") - num_legend_dots;
  const std::regex text(R"re(<text class="(?:label|name)" x="([^"]*)" y="([^"]*)">([^<]*)</text>)re");
  for (std::sregex_iterator m(svg.begin(), svg.end(), text), end; m != end; ++m)
    result.labels.push_back({std::stod((*m)[1]), std::stod((*m)[2]), text_width((*m)[3], 13), (*m)[3]});
  return result;
}

void expect_no_overlap(const std::vector<Label>& labels) {
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Label &a = labels[i], &b = labels[k];
      EXPECT_TRUE(std::abs(a.x - b.x) >= 0.5 * (a.width + b.width) || std::abs(a.y - b.y) >= 13)
          << a.text << " and " << b.text;
    }
}

TEST(CurveLabels, EachCurveHasItsNumberAndGivenName) {
  const Drawn d = drawn(polygon(8, "inlet"), 600);
  ASSERT_EQ(d.labels.size(), 8);
  EXPECT_EQ(d.num_omitted, 0);
  EXPECT_EQ(d.num_lines, 0) << "there is room beside each curve";
  EXPECT_EQ(d.num_joints, 4) << "the others are corners";
  std::vector<std::string> texts;
  for (const Label& label : d.labels) texts.push_back(label.text);
  std::sort(texts.begin(), texts.end());
  EXPECT_EQ(texts, (std::vector<std::string>{"0 inlet", "1", "2", "3", "4", "5", "6", "7"}));
  expect_no_overlap(d.labels);
}

TEST(CurveLabels, CrowdedCurvesGetLinesAndNoOverlap) {
  const Drawn d = drawn(polygon(150, "a rather long name of a curve"), 600);
  EXPECT_EQ(d.labels.size() + static_cast<std::size_t>(d.num_omitted), 150);
  EXPECT_LT(d.num_omitted, 15);
  EXPECT_GT(d.num_lines, 20);
  expect_no_overlap(d.labels);
}

TEST(CurveLabels, WithoutRoomTheNameIsOmittedFirst) {
  const Drawn d = drawn(polygon(4, std::string(200, 'x')), 200);
  ASSERT_EQ(d.labels.size(), 4);
  for (const Label& label : d.labels) EXPECT_EQ(label.text.size(), 1) << label.text;
}

TEST(CurveLabels, ADegenerateCurveIsNoError) {
  CadFace face = polygon(4, "wall");
  face.curves[2] = curve::segment(face.joints[2].position, face.joints[2].position);
  EXPECT_EQ(drawn(face, 400).labels.size(), 4);
}

TEST(CurveLabels, GivenNamesStandOnceForSuccessiveCurves) {
  CadFace face = polygon(8, "inlet");
  face.curve_names = {"inlet", "curve_1", "wall", "wall", "wall", "outlet", "curve_6", "inlet"};
  face.unnamed_curves = {1, 6};
  const Drawn d = drawn(face, 600, CurveLabels::given);
  std::vector<std::string> texts;
  for (const Label& label : d.labels) texts.push_back(label.text);
  std::sort(texts.begin(), texts.end());
  EXPECT_EQ(texts, (std::vector<std::string>{"inlet", "outlet", "wall"})) << "curves 7 and 0 are successive";
  EXPECT_EQ(d.num_joints, 0);
  expect_no_overlap(d.labels);
  face.curve_names.assign(8, "wall");
  face.unnamed_curves.clear();
  EXPECT_EQ(drawn(face, 600, CurveLabels::given).labels.size(), 1) << "a loop with one name";
  EXPECT_EQ(drawn(face, 600, CurveLabels::none).labels.size(), 0);
}

TEST(CurveLabels, OtherTextsAreNotCovered) {
  const CadFace face = polygon(4, "inlet");
  DrawOptions options;
  options.width = 600;
  Picture picture(bounding_box(face), options, "", "");
  const auto first = [](const Picture& p) { return p.text_boxes().back(); };
  label_curves(picture, face, CurveLabels::given);
  Picture crowded(bounding_box(face), options, "", "");
  crowded.text(first(picture).centre, "label", "7");
  label_curves(crowded, face, CurveLabels::given);
  EXPECT_FALSE(first(crowded).overlaps(crowded.text_boxes().front()));
}

/// A square with a slim rectangular hole in its middle, whose long sides are called `upper` and `lower`.
CadFace square_with_slim_hole(double half_height) {
  const std::vector<Vec2> outline{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double h = half_height;
  const std::vector<Vec2> hole{{-0.5, -h}, {-0.5, h}, {0.5, h}, {0.5, -h}};
  CadFace face;
  for (const std::vector<Vec2>& loop : {outline, hole})
    for (std::size_t i = 0; i < 4; ++i) face.curves.push_back(curve::segment(loop[i], loop[(i + 1) % 4]));
  face.curve_names = {"c0", "c1", "c2", "c3", "c4", "upper", "c6", "lower"};
  face.unnamed_curves = {0, 1, 2, 3, 4, 6};
  face.joints.resize(8);
  face.loop_offsets = {0, 4, 8};
  face.diameter = 2 * std::sqrt(2.0);
  return face;
}

TEST(CurveLabels, OfAThinHoleTheyLieOnTheSidesThatTheyName) {
  for (const double half_height : {0.001, 0.01, 0.03, 0.3}) {
    std::map<std::string, double> y;  // down
    for (const Label& label : drawn(square_with_slim_hole(half_height), 600, CurveLabels::given).labels)
      y[label.text] = label.y;
    ASSERT_EQ(y.size(), 2u) << half_height;
    EXPECT_LT(y["upper"] + 13, y["lower"]) << half_height;
  }
}

TEST(CurveLabels, OfAnyHoleTheyAreNearestToTheSidesThatTheyName) {
  // Labels have room in the hole from 16 pixels on, and are nearer to their own side from twice as many on.
  int num_inside = 0;
  for (int pixels = 4; pixels <= 120; pixels += 4) {
    const CadFace face = square_with_slim_hole(pixels / 600.0);
    DrawOptions options;
    options.width = 600;
    Picture picture(bounding_box(face), options, "", "");
    const double upper = picture.at({0, pixels / 600.0}).y, lower = picture.at({0, -pixels / 600.0}).y;
    label_curves(picture, face, CurveLabels::given);
    const std::vector<TextBox>& boxes = picture.text_boxes();
    ASSERT_EQ(boxes.size(), 2U) << pixels;
    const auto& [a, b] = std::pair(boxes[0], boxes[1]);
    const auto offset = [](const TextBox& box, double y) { return std::abs(box.centre.y - y); };
    EXPECT_LT(std::min(offset(a, upper), offset(b, upper)), 25) << pixels;
    EXPECT_LT(std::min(offset(a, lower), offset(b, lower)), 25) << pixels;
    EXPECT_NE(offset(a, upper) < offset(a, lower), offset(b, upper) < offset(b, lower)) << pixels;
    num_inside += a.centre.y > std::min(upper, lower) && a.centre.y < std::max(upper, lower);
  }
  EXPECT_GT(num_inside, 5);
  EXPECT_LT(num_inside, 28);
}

TEST(CurveLabels, RunsOfOneNameStartAtTheirFirstCurve) {
  CadFace face = polygon(6, "inlet");
  face.curve_names = {"inlet", "wall", "wall", "curve_3", "wall", "inlet"};
  face.unnamed_curves = {3};
  EXPECT_EQ(name_runs(face), (std::vector<int>{5, 1, 1, -1, 4, 5}));
}

TEST(CurveLabels, AnInterfaceHasOneLabelWithBothNumbers) {
  CadFace face = samples::two_regions_face();
  const auto texts = [&](CurveLabels which) {
    std::set<std::string> all;
    for (const Label& label : drawn(face, 900, which).labels) all.insert(label.text);
    return all;
  };
  EXPECT_TRUE(texts(CurveLabels::all).contains("1/7"));
  EXPECT_FALSE(texts(CurveLabels::all).contains("7"));
  EXPECT_FALSE(texts(CurveLabels::given).contains("fluid-solid")) << "made from the names of the regions";
  face.curve_names[1] = face.curve_names[7] = "skin";
  face.unnamed_curves = {};
  EXPECT_TRUE(texts(CurveLabels::all).contains("1/7 skin"));
  EXPECT_TRUE(texts(CurveLabels::given).contains("skin"));
}

}  // namespace

}  // namespace quadrille::draw
