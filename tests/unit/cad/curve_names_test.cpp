#include "cad/curve_names.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::cad {

namespace {

using Kind = NameRule::Kind;
using Names = std::vector<std::string>;

/// The upper half of the unit disc, in a plane of its own: the diameter is curve 0, the arc curves 1 and 2.
CadFace half_disc() {
  CadFace face;
  face.curves = {curve::segment({-1, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, half_pi),
                 curve::circular_arc({0, 0}, 1, half_pi, pi)};
  face.curve_names = {"axis", "arc", "arc"};
  face.diameter = 2;
  face.origin = {100, 0};
  face.plane_origin = {1, 2, 3};
  face.plane_x = {0, 1, 0}, face.plane_y = {0, 0, 1};
  return face;
}

NameRule rule(Kind kind, const std::string& text, int number, std::vector<double> position = {}) {
  return {kind, text, number, std::move(position), "new", "n: entry 0"};
}

void rename(CadFace& face, const std::vector<NameRule>& rules, const std::vector<NameRule>& overriding = {}) {
  Report unused;
  rename_curves(face, rules, overriding, unused);
}

Names renamed(const NameRule& r) {
  CadFace face = half_disc();
  rename(face, {r});
  return face.curve_names;
}

std::string refusal(const NameRule& r) {
  return message_of<FormatError>([&] { renamed(r); });
}

TEST(RenameCurves, RenamedCurvesHaveGivenNames) {
  CadFace face = half_disc();
  face.unnamed_curves = {0, 1, 2};
  rename(face, {rule(Kind::number, "", 1)});
  EXPECT_EQ(face.unnamed_curves, (std::vector<int>{0, 2}));
}

TEST(RenameCurves, ByNameAndNumber) {
  EXPECT_EQ(renamed(rule(Kind::key, "arc", -1)), (Names{"axis", "new", "new"}));
  EXPECT_EQ(renamed(rule(Kind::key, "1", 1)), (Names{"axis", "new", "arc"}));
  EXPECT_EQ(renamed(rule(Kind::number, "", 2)), (Names{"axis", "arc", "new"}));
  EXPECT_EQ(renamed(rule(Kind::old_name, "axis", -1)), (Names{"new", "arc", "arc"}));
  EXPECT_EQ(renamed(rule(Kind::rest, "", -1)), (Names{"new", "new", "new"}));
  EXPECT_EQ(refusal(rule(Kind::old_name, "1", 1)),
            "n: entry 0: no boundary curve has this name or number; the curves are 0 \"axis\", 1 \"arc\", 2 \"arc\"");
  EXPECT_NE(refusal(rule(Kind::number, "", 3)), "");
  EXPECT_NE(refusal(rule(Kind::key, "-1", -1)), "");
}

TEST(RenameCurves, ANameThatIsANumberGoesBeforeTheNumber) {
  CadFace face = half_disc();
  face.curve_names = {"1", "b", "c"};
  rename(face, {rule(Kind::key, "1", 1)});
  EXPECT_EQ(face.curve_names, (Names{"new", "b", "c"}));
}

TEST(RenameCurves, OldNamesAreThoseBeforeTheFirstChange) {
  CadFace face = half_disc();
  rename(face, {{Kind::key, "axis", -1, {}, "arc", "n: 0"}, {Kind::key, "arc", -1, {}, "axis", "n: 1"}});
  EXPECT_EQ(face.curve_names, (Names{"arc", "axis", "axis"}));
}

TEST(RenameCurves, ByTheNearestPointInTheFacesCoordinatesOrInSpace) {
  EXPECT_EQ(renamed(rule(Kind::position, "", -1, {100.2, -0.3})), (Names{"new", "arc", "arc"}));
  EXPECT_EQ(renamed(rule(Kind::position, "", -1, {100.6, 0.7})), (Names{"axis", "new", "arc"}));
  EXPECT_EQ(renamed(rule(Kind::position, "", -1, {1, 2 + 99.4, 3 + 0.7})), (Names{"axis", "arc", "new"}));
}

TEST(RenameCurves, PlacesThatDoNotTellAreRefused) {
  EXPECT_EQ(refusal(rule(Kind::position, "", -1, {101, 0})),
            "n: entry 0: (101, 0) is equally near to the curves 0 \"axis\" and 1 \"arc\"");
  EXPECT_NE(refusal(rule(Kind::position, "", -1, {100, 1})).find("1 \"arc\" and 2 \"arc\""), std::string::npos);
  EXPECT_EQ(refusal(rule(Kind::position, "", -1, {0.6, 0.7})),
            "n: entry 0: (0.6, 0.7) lies 98.4 away from the boundary, whose diameter is 2");
  EXPECT_EQ(refusal(rule(Kind::position, "", -1, {1.5, 102, 3.5})),
            "n: entry 0: (1.5, 102, 3.5) lies 0.5 off the plane of the face");
}

TEST(RenameCurves, TwoRulesForOneCurveAreRefused) {
  CadFace face = half_disc();
  try {
    rename(face, {{Kind::key, "arc", -1, {}, "wall", "n: entry 0"}, rule(Kind::position, "", -1, {100.6, 0.7})});
    FAIL() << "";
  } catch (const FormatError& e) {
    EXPECT_NE(std::string(e.what()).find("names curve 1, as n: entry 0 does"), std::string::npos) << e.what();
  }
  EXPECT_EQ(face.curve_names, (Names{"axis", "arc", "arc"})) << "all or nothing";
}

/// Names by --name in a half disc, whose names a file may have changed by `rules`.
Names named(const std::vector<std::string>& options, const std::vector<NameRule>& rules = {}) {
  CadFace face = half_disc();
  rename(face, rules, name_option_rules(options));
  return face.curve_names;
}

TEST(RenameCurves, ByOptionsWithNumbersRangesPatternsAndPoints) {
  EXPECT_EQ(named({"hole=2"}), (Names{"axis", "arc", "hole"}));
  EXPECT_EQ(named({"wall=0,1-2"}), (Names{"wall", "wall", "wall"}));
  EXPECT_EQ(named({"wall=a?c,1"}), (Names{"axis", "wall", "wall"}));
  EXPECT_EQ(named({"wall=*", "hole@100.6,0.7"}), (Names{"wall", "hole", "wall"}));
  EXPECT_EQ(named({"wall=1", "wall=arc"}), (Names{"axis", "wall", "wall"})) << "twice, but equal";
}

TEST(RenameCurves, OptionsWinOverAFileAndMeanTheSameOldNames) {
  const NameRule arc{Kind::old_name, "arc", -1, {}, "axis", "n: 0"};
  const NameRule rest{Kind::rest, "", -1, {}, "other", "n: 1"};
  EXPECT_EQ(named({"top=1"}, {arc, rest}), (Names{"other", "top", "axis"}));
  EXPECT_EQ(named({"top=axis"}, {arc}), (Names{"top", "axis", "axis"}));
  EXPECT_EQ(named({"top=*"}, {arc, rest}), (Names{"top", "axis", "axis"}));
}

TEST(RenameCurves, OptionsWithoutAMatchListWhatExists) {
  const auto message = [](const std::string& option) { return message_of<FormatError>([&] { named({option}); }); };
  EXPECT_EQ(message("x=edge_*"),
            "--name x=edge_*: no boundary curve has the name edge_*; the curves are 0 \"axis\", 1 \"arc\", 2 \"arc\"");
  EXPECT_EQ(message("x=1-3"),
            "--name x=1-3: no boundary curve has the number 3; the curves are 0 \"axis\", 1 \"arc\", 2 \"arc\"");
  EXPECT_EQ(message("x@100,1.5"),
            "--name x@100,1.5: (100, 1.5) lies 0.5 away from the boundary, whose diameter is 2 (at most 0.1 of it)");
  EXPECT_EQ(message("x@101,0"), "--name x@101,0: (101, 0) is equally near to the curves 0 \"axis\" and 1 \"arc\"");
  EXPECT_EQ(message_of<FormatError>([] {
              named({"x=1", "y=arc"});
            }),
            "--name y=arc names curve 1, as --name x=1 does: \"y\" or \"x\"?");
}

/// Two half discs on each other, whose common diameter is the curves 0 and 3, and a curve inside the upper one.
CadFace divided_disc() {
  CadFace face = half_disc();
  face.curves.push_back(curve::segment({1, 0}, {-1, 0}));
  face.curves.push_back(curve::circular_arc({0, 0}, 1, pi, 2 * pi));
  face.curves.push_back(curve::segment({-0.1, 0.3}, {0.1, 0.3}));
  face.curves.push_back(curve::segment({0.1, 0.3}, {-0.1, 0.3}));
  face.curve_names = {"axis", "arc", "arc", "axis", "bow", "crack", "crack"};
  face.partners = {3, -1, -1, 0, -1, 6, 5};
  return face;
}

struct Renamed {
  Names names;
  std::vector<Report::Warning> warnings;
};

Renamed divided(const std::vector<std::string>& options, const std::vector<NameRule>& rules = {}) {
  CadFace face = divided_disc();
  Report report;
  rename_curves(face, rules, name_option_rules(options), report);
  return {face.curve_names, report.warnings()};
}

TEST(RenameCurves, TheRestIsOfTheBoundaryAndInterfacesAreNamedApart) {
  EXPECT_EQ(divided({"wall=*"}).names, (Names{"axis", "wall", "wall", "axis", "wall", "crack", "crack"}));
  EXPECT_EQ(divided({"joint=interface:*"}).names, (Names{"joint", "arc", "arc", "joint", "bow", "joint", "joint"}));
  EXPECT_EQ(divided({"top=bow", "wall=*", "bond=0", "joint=interface:*"}).names,
            (Names{"bond", "wall", "wall", "bond", "top", "joint", "joint"}));
  EXPECT_EQ(divided({"x=interface:a*"}).names, (Names{"x", "arc", "arc", "x", "bow", "crack", "crack"}));
  EXPECT_EQ(divided({"x=boundary:a*,boundary:bow"}).names, (Names{"axis", "x", "x", "axis", "x", "crack", "crack"}));
  EXPECT_EQ(message_of<FormatError>([] { named({"x=interface:*"}); }),
            "--name x=interface:*: the face has no interface, nor a curve inside it");
  EXPECT_NE(message_of<FormatError>([] { divided({"x=interface:bow"}); }).find("no interface has the name bow;"),
            std::string::npos);
}

TEST(RenameCurves, OptionsForOneRestLeaveTheOtherToTheFile) {
  const NameRule rest{Kind::rest, "", -1, {}, "other", "n: 1"};
  NameRule joints{Kind::rest, "", -1, {}, "seam", "n: 2"};
  joints.part = NameRule::Part::interface;
  EXPECT_EQ(divided({"wall=*"}, {rest, joints}).names, (Names{"seam", "wall", "wall", "seam", "wall", "seam", "seam"}));
  EXPECT_EQ(divided({"bond=interface:*"}, {rest, joints}).names,
            (Names{"bond", "other", "other", "bond", "other", "bond", "bond"}));
}

TEST(RenameCurves, OneNameForBothKindsIsAWarning) {
  for (const std::string option : {"x=a*", "x=0-1", "x=a*,crack"}) {
    const Renamed result = divided({option});
    ASSERT_EQ(result.warnings.size(), 1u) << option;
    EXPECT_EQ(result.warnings[0].code, "W-CAD-010");
  }
  EXPECT_EQ(divided({"x=a*"}).warnings[0].message.find("--name x=a* names 2 curves of the boundary and 1 curve inside"),
            0u);
  EXPECT_EQ(divided({"x=a*"}).names, (Names{"x", "x", "x", "x", "bow", "crack", "crack"})) << "named all the same";
  for (const std::string option : {"x=arc", "x=crack", "x=1-2", "x=*", "x=interface:*", "x=boundary:a*", "x=0"})
    EXPECT_TRUE(divided({option}).warnings.empty()) << option;
}

heal::RawEdge edge(const std::string& name, const std::string& layer, const std::string& colour) {
  heal::RawEdge e;
  e.name = name, e.layer = layer, e.colour = colour;
  return e;
}

/// The names of the edges, and that of the face at the end.
Names chosen(std::vector<heal::RawEdge> edges, const std::string& face_name = "", const std::string& face_layer = "") {
  heal::RawFace raw;
  raw.name = face_name, raw.layer = face_layer;
  for (heal::RawEdge& e : edges) raw.wires.push_back({std::move(e)});
  choose_names(raw);
  Names names;
  for (const auto& wire : raw.wires) names.push_back(wire.front().name);
  names.push_back(raw.name);
  return names;
}

TEST(ChooseNames, name_before_layer_before_colour) {
  EXPECT_EQ(chosen({edge("inlet", "walls", "ff0000"), edge("", "walls", "ff0000"), edge("", "", "ff0000"),
                    edge("", "", "0000ff"), edge("", "", "")}),
            (Names{"inlet", "walls", "colour_ff0000", "colour_0000ff", "", ""}));
}

TEST(ChooseNames, the_layer_of_the_part_names_neither_edges_nor_face) {
  EXPECT_EQ(chosen({edge("", "1", ""), edge("", "wall", "")}, "", "1"), (Names{"", "wall", ""}));
}

TEST(ChooseNames, one_layer_for_all_edges_is_their_name) {
  EXPECT_EQ(chosen({edge("", "wall", ""), edge("", "wall", "")}, "", "fluid"), (Names{"wall", "wall", "fluid"}));
  EXPECT_EQ(chosen({edge("", "wall", ""), edge("", "wall", "")}, "air", "fluid"), (Names{"wall", "wall", "air"}));
}

TEST(ChooseNames, one_colour_for_all_of_several_edges_says_nothing) {
  EXPECT_EQ(chosen({edge("", "", "000000"), edge("", "", "000000")}), (Names{"", "", ""}));
  EXPECT_EQ(chosen({edge("", "", "000000")}), (Names{"colour_000000", ""}));
  EXPECT_EQ(chosen({edge("", "", "000000"), edge("", "", "")}), (Names{"colour_000000", "", ""}));
}

TEST(NameOptions, AListIsOneRuleForEachItem) {
  const std::vector<NameRule> rules = name_option_rules({"wall=1,3-6,edge_*,*"});
  ASSERT_EQ(rules.size(), 4);
  EXPECT_TRUE(rules[0].kind == Kind::range && rules[0].number == 1 && rules[0].last_number == 1);
  EXPECT_TRUE(rules[1].kind == Kind::range && rules[1].number == 3 && rules[1].last_number == 6);
  EXPECT_TRUE(rules[2].kind == Kind::pattern && rules[2].text == "edge_*");
  EXPECT_TRUE(rules[3].kind == Kind::rest);
  for (const NameRule& rule : rules) EXPECT_EQ(rule.name + rule.where, "wall--name wall=1,3-6,edge_*,*");
}

TEST(NameOptions, APointHasTwoOrThreeCoordinates) {
  const std::vector<NameRule> rules = name_option_rules({" out let @21,-1e-1", "top@1,2,3"});
  ASSERT_EQ(rules.size(), 2);
  EXPECT_EQ(rules[0].name, "out let");
  EXPECT_EQ(rules[0].position, (std::vector<double>{21, -0.1}));
  EXPECT_EQ(rules[0].max_distance, max_option_distance);
  EXPECT_EQ(rules[1].position, (std::vector<double>{1, 2, 3}));
}

TEST(NameOptions, MistakesAreRefused) {
  const auto message = [](const std::string& option) {
    return message_of<UsageError>([&] { name_option_rules({option}); });
  };
  for (const char* option : {"wall", "=3", "@1,2", "", " =3"})
    EXPECT_NE(message(option).find("expected NAME=LIST"), std::string::npos) << option;
  for (const char* option : {"w@1", "w@1,2,3,4", "w@a,b", "w@1,", "w@1,inf"})
    EXPECT_NE(message(option).find("a point is X,Y or X,Y,Z"), std::string::npos) << option;
  for (const char* option : {"w=", "w=1,,2", "w=1,"})
    EXPECT_NE(message(option).find("an item of the list is empty"), std::string::npos) << option;
}

TEST(NameOptions, WhatIsNoNumberOrRangeIsAName) {
  for (const char* item : {"-1", "6-3", "1-", "1-2-3", "99999999999"})
    EXPECT_TRUE(name_option_rules({std::string("w=") + item}).front().kind == Kind::pattern) << item;
}

}  // namespace

}  // namespace quadrille::cad
