#include "cad/region_names.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <utility>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "cad/curve_names.hpp"
#include "curve/nurbs.hpp"
#include "outline/extent.hpp"
#include "outline/face_of_loops.hpp"

namespace quadrille::cad {

namespace {

/// Two unit squares side by side; curves 1 and 7 are the side that they share.
CadFace two_squares() {
  CadFace face;
  for (const double x : {0.0, 1.0}) {
    const Vec2 corners[] = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
    for (int i = 0; i < 4; ++i) face.curves.push_back(curve::segment(corners[i], corners[(i + 1) % 4]));
  }
  face.loop_offsets = {0, 4, 8}, face.region_loops = {0, 1, 2};
  face.region_names = {"left", "region_1"};
  face.partners = {-1, 7, -1, -1, -1, -1, -1, 1};
  face.diameter = std::sqrt(5.0);
  for (int c = 0; c < 8; ++c) {
    face.curve_names.push_back("curve_" + std::to_string(c));
    face.unnamed_curves.push_back(c);
    face.curve_cad_edges.push_back(c);
  }
  face.joints.resize(8);
  name_interfaces(face);
  return face;
}

CadFace renamed(const std::vector<std::string>& options) {
  CadFace face = two_squares();
  rename_regions(face, name_option_rules(options, "--region-name"));
  return face;
}

std::string refusal(const std::string& option) {
  return message_of<FormatError>([&] { renamed({option}); });
}

TEST(RegionNames, InterfacesAreNamedAfterBothRegions) {
  const CadFace face = two_squares();
  EXPECT_EQ(face.curve_names[1], "left-region_1");
  EXPECT_EQ(face.curve_names[7], "left-region_1");
  EXPECT_EQ(face.curve_names[0], "curve_0");
}

TEST(RegionNames, TheSidesOfASlitHaveOneName) {
  CadFace face = two_squares();
  face.partners = {-1, -1, 3, 2, -1, -1, -1, -1};
  face.curve_names[3] = "curve_3";
  name_interfaces(face);
  EXPECT_EQ(face.curve_names[3], "curve_2");
}

TEST(RegionNames, AreGivenByNumberNamePatternPointAndForTheRest) {
  EXPECT_EQ(renamed({"fluid=1"}).region_names, (std::vector<std::string>{"left", "fluid"}));
  EXPECT_EQ(renamed({"fluid=le*", "left=region_1"}).region_names, (std::vector<std::string>{"fluid", "left"}));
  EXPECT_EQ(renamed({"solid@1.5,0.5"}).region_names, (std::vector<std::string>{"left", "solid"}));
  EXPECT_EQ(renamed({"a=0", "b=*"}).region_names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(renamed({"all=0-1"}).region_names, (std::vector<std::string>{"all", "all"}));
}

TEST(RegionNames, InterfacesFollowUnlessTheirNameIsGiven) {
  EXPECT_EQ(renamed({"fluid=1"}).curve_names[7], "left-fluid");
  CadFace face = two_squares();
  Report unused;
  rename_curves(face, {}, name_option_rules({"bond=7"}), unused);
  EXPECT_EQ(face.curve_names[1], "bond") << "both sides";
  EXPECT_FALSE(std::binary_search(face.unnamed_curves.begin(), face.unnamed_curves.end(), 1));
  rename_regions(face, name_option_rules({"fluid=1"}, "--region-name"));
  EXPECT_EQ(face.curve_names[7], "bond");
}

TEST(RegionNames, APointOnAnInterfaceIsNearestToItsBothSides) {
  CadFace face = two_squares();
  Report unused;
  rename_curves(face, {}, name_option_rules({"bond@1,0.5"}), unused);
  EXPECT_EQ(face.curve_names[1], "bond");
  EXPECT_EQ(face.curve_names[7], "bond");
}

TEST(RegionNames, ASingleRegionIsTheFace) {
  CadFace face = two_squares();
  face.curves.resize(4), face.loop_offsets = {0, 4};
  face.region_loops.clear(), face.region_names.clear(), face.partners.clear();
  rename_regions(face, name_option_rules({"plate=0"}, "--region-name"));
  EXPECT_EQ(face.name, "plate");
  EXPECT_TRUE(face.region_names.empty());
}

TEST(RegionNames, TheNamedRegionsAreReturned) {
  CadFace face = two_squares();
  EXPECT_EQ(rename_regions(face, name_option_rules({"x=1"}, "--region-name")), std::vector<int>{1});
  EXPECT_EQ(rename_regions(face, name_option_rules({"x=*"}, "--region-name")), (std::vector<int>{0, 1}));
}

TEST(RegionNames, RulesWithoutARegionAreRefused) {
  EXPECT_EQ(refusal("x=2"),
            "--region-name x=2: no region has the number 2; the regions are 0 \"left\", 1 \"region_1\"");
  EXPECT_NE(refusal("x=lift").find("no region has the name lift"), std::string::npos);
  EXPECT_NE(refusal("x@3,3").find("(3, 3) is in no region"), std::string::npos);
  EXPECT_NE(refusal("x@1,0.5").find("on the boundary of a region"), std::string::npos);
  EXPECT_NE(message_of<UsageError>([] { renamed({"x=interface:*"}); }).find("are for names of curves"),
            std::string::npos);
}

constexpr double corner_angle = radians(1);

using Corners = std::vector<Vec2>;

/// Polygons, each a region called after its number; sides with the same ends are common.
CadFace polygons(const std::vector<Corners>& regions) {
  CadFace face;
  face.loop_offsets = face.region_loops = {0};
  std::map<std::array<double, 4>, int> known;
  for (const Corners& corners : regions) {
    for (size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
      const int c = face.num_curves();
      face.curves.push_back(curve::segment(a, b));
      face.partners.push_back(-1);
      face.unnamed_curves.push_back(c);
      face.curve_cad_edges.push_back(c);
      known[{a.x, a.y, b.x, b.y}] = c;
      if (const auto twin = known.find({b.x, b.y, a.x, a.y}); twin != known.end())
        face.partners[c] = twin->second, face.partners[twin->second] = c;
    }
    face.loop_offsets.push_back(face.num_curves());
    face.region_names.push_back(std::to_string(face.region_loops.size() - 1));
    face.region_loops.push_back(face.num_loops());
  }
  face.curve_names.assign(face.num_curves(), "curve");
  for (int c = 0; c < face.num_curves(); ++c)
    face.joints.push_back(outline::joint_between(face.curves[face.previous_in_loop(c)], face.curves[c], corner_angle));
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.partners[c] == face.previous_in_loop(c))
      face.joints[c].interior_angle = 2 * pi, face.joints[c].is_corner = true;
  face.diameter = 3;
  return face;
}

Corners square(double x, double y) { return {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}; }

CadFace merged(CadFace face, const std::vector<std::string>& names, const std::vector<int>& named) {
  face.region_names = names;
  merge_regions(face, named, corner_angle);
  return face;
}

/// Every curve of the face starts where its predecessor ends, and partners run along each other.
void expect_closed(const CadFace& face) {
  for (int c = 0; c < face.num_curves(); ++c) {
    EXPECT_EQ(face.curves[face.previous_in_loop(c)].poles.back(), face.curves[c].poles.front()) << c;
    EXPECT_EQ(face.joints[c].position, face.curves[c].poles.front()) << c;
    if (!face.is_interface(c)) continue;
    EXPECT_EQ(face.partners[face.partners[c]], c);
    EXPECT_EQ(face.curves[face.partners[c]].poles.front(), face.curves[c].poles.back());
  }
}

TEST(MergeRegions, TwoSquaresAreOneFaceWithSmoothJoints) {
  const CadFace face = merged(polygons({square(0, 0), square(1, 0)}), {"plate", "plate"}, {0, 1});
  expect_closed(face);
  EXPECT_EQ(face.num_regions(), 1);
  EXPECT_EQ(face.name, "plate");
  EXPECT_TRUE(face.region_names.empty() && face.partners.empty());
  EXPECT_EQ(face.num_curves(), 6);
  EXPECT_EQ(face.curve_names[5], "curve_5");
  EXPECT_EQ(face.curve_cad_edges, (std::vector<int>{0, 4, 5, 6, 2, 3}));
  EXPECT_DOUBLE_EQ(outline::area(face), 2);
  EXPECT_DOUBLE_EQ(face.joints[1].interior_angle, pi);
  EXPECT_FALSE(face.joints[1].is_corner);
  EXPECT_TRUE(face.joints[2].is_corner);
}

TEST(MergeRegions, OtherNeighboursKeepTheirCurves) {
  const CadFace face =
      merged(polygons({square(0, 0), square(1, 0), square(2, 0), square(0, 1)}), {"a", "b", "b", "a"}, {0, 1, 2, 3});
  expect_closed(face);
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(face.num_curves(), 12);
  const auto bond = std::find_if(face.partners.begin(), face.partners.end(), [](int p) { return p >= 0; });
  EXPECT_EQ(face.curve_names[bond - face.partners.begin()], "a-b");
  EXPECT_DOUBLE_EQ(outline::area(face), 4);
}

TEST(MergeRegions, OnlyNamedRegionsThatTouchAreMerged) {
  const CadFace three = polygons({square(0, 0), square(1, 0), square(2, 0)});
  EXPECT_EQ(merged(three, {"x", "x", "x"}, {0, 2}).num_regions(), 3) << "apart, and the middle is named in the file";
  EXPECT_EQ(merged(three, {"x", "y", "x"}, {0, 1, 2}).num_regions(), 3);
  EXPECT_EQ(merged(three, {"x", "x", "x"}, {1, 2}).num_regions(), 2);
}

TEST(MergeRegions, ARingOfSquaresHasAHole) {
  std::vector<Corners> squares;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) squares.push_back(square(x, y));
  CadFace face = merged(polygons(squares), {"r", "r", "r", "r", "core", "r", "r", "r", "r"}, {0, 1, 2, 3, 5, 6, 7, 8});
  expect_closed(face);
  EXPECT_EQ(face.region_names, (std::vector<std::string>{"r", "core"}));
  EXPECT_EQ(face.region_loops, (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(face.loop_offsets, (std::vector<int>{0, 12, 16, 20}));
  EXPECT_DOUBLE_EQ(outline::area(face), 9);
  face = merged(polygons(squares), std::vector<std::string>(9, "all"), {0, 1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_EQ(face.num_loops(), 1) << "the core is gone with its hole";
}

TEST(MergeRegions, ARegionThatWouldTouchItselfIsRefused) {
  std::vector<Corners> squares;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) squares.push_back(square(x, y));
  EXPECT_EQ(message_of<FormatError>([&] {
              merged(polygons(squares), {"r", "r", "r", "r", "a", "r", "r", "r", "b"}, {0, 1, 2, 3, 5, 6, 7});
            }),
            "--region-name: 'r' would be one region that touches itself at (2, 2): give its faces two names, or "
            "--keep-joints");
}

TEST(MergeRegions, ACurveThatEndedAtTheJointEndsInside) {
  CadFace face = polygons(
      {{{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {1, 0.5}, {1, 1}, {0, 1}}, {{1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.5}}});
  face = merged(face, {"x", "x"}, {0, 1});
  expect_closed(face);
  ASSERT_EQ(face.num_loops(), 2) << "the curve inside is a loop of its own";
  EXPECT_TRUE(face.is_slit_loop(1));
  for (int c = face.loop_offsets[1]; c < face.num_curves(); ++c) {
    EXPECT_DOUBLE_EQ(face.joints[c].interior_angle, 2 * pi);
    EXPECT_TRUE(face.joints[c].is_corner);
  }
  EXPECT_DOUBLE_EQ(outline::area(face), 2);
}

}  // namespace

}  // namespace quadrille::cad
