#include "cad/region_names.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "cad/curve_names.hpp"
#include "cad/name_options.hpp"
#include "curve/nurbs.hpp"

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

}  // namespace
}  // namespace quadrille::cad
