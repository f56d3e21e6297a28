#include "export/groups.hpp"

#include <gtest/gtest.h>

#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

TEST(Groups, CurvesOfOneNameAreOneBoundaryAndThoseWithoutANameGetOne) {
  const Groups groups = mesh_groups(two_quads());
  EXPECT_EQ(groups.boundary_names, (std::vector<std::string>{"wall", "in & out", "curve_3"}));
  EXPECT_EQ(groups.curve2boundary, (std::vector<int>{0, 1, 0, 2}));
}

TEST(MeshGroups, ACurveWithoutEdgesIsNoGroup) {
  QuadMesh mesh = two_quads();
  for (QuadBoundaryEdge& edge : mesh.boundary_edges)
    if (edge.curve == 1) edge.curve = 3;
  const Groups groups = mesh_groups(mesh);
  EXPECT_EQ(groups.boundary_names, (std::vector<std::string>{"wall", "curve_3"}));
  EXPECT_EQ(groups.curve2boundary, (std::vector<int>{0, -1, 0, 1}));
}

TEST(Groups, BlocksOfOneNameAreOneRegion) {
  EXPECT_EQ(mesh_groups(two_quads()).block2region, (std::vector<int>{0, 1}));
  const Groups groups = mesh_groups(two_quads_of_the_pages());
  EXPECT_EQ(groups.region_names, std::vector<std::string>{"fluid"});
  EXPECT_EQ(groups.block2region, (std::vector<int>{0, 0}));
}

TEST(Groups, BlocksWithoutANameAreOneRegion) {
  QuadMesh mesh = two_quads();
  mesh.unnamed_blocks = {0, 1};
  EXPECT_EQ(mesh_groups(mesh).region_names, std::vector<std::string>{"domain"});
  EXPECT_EQ(mesh_groups(mesh).is_region_named, std::vector<bool>{false});
  mesh.unnamed_blocks = {0};
  mesh.block_names[1] = "domain";
  EXPECT_EQ(mesh_groups(mesh).region_names, (std::vector<std::string>{"domain_", "domain"}));
  EXPECT_EQ(mesh_groups(mesh).is_region_named, (std::vector<bool>{false, true}));
}

TEST(Groups, SeparatedBlocksKeepNamesOfTheirOwn) {
  QuadMesh mesh = two_quads();
  mesh.face.name = "left";
  separate_blocks(mesh);
  EXPECT_EQ(mesh_groups(mesh).region_names, (std::vector<std::string>{"block_0", "right"}));
  mesh = two_quads();
  mesh.unnamed_blocks = {0, 1};
  separate_blocks(mesh);
  EXPECT_EQ(mesh_groups(mesh).region_names, (std::vector<std::string>{"block_0", "block_1"}));
  EXPECT_EQ(mesh_groups(mesh).is_region_named, (std::vector<bool>{true, true}));
}

TEST(NamesTable, ListsGroupsWithTheirNumbers) {
  Groups groups;
  groups.boundary_names = {"wall", "outlet"};
  groups.region_names = {"block_0"};
  const SideFile table = names_table(groups, groups.boundary_names, groups.region_names);
  EXPECT_EQ(table.name.ending, ".names.json");
  EXPECT_FALSE(table.is_binary);
  EXPECT_EQ(table.bytes, R"({
  "boundaries": [
    {"id": 1, "name": "wall"},
    {"id": 2, "name": "outlet"}
  ],
  "regions": [
    {"id": 1, "name": "block_0"}
  ]
}
)");
}

TEST(NamesTable, EscapesWhatJsonAsksFor) {
  Groups groups;
  groups.boundary_names = {"a\"b\\c\n\xc3\xa4"};
  const SideFile table = names_table(groups, groups.boundary_names, {});
  EXPECT_EQ(table.bytes,
            "{\n  \"boundaries\": [\n    {\"id\": 1, \"name\": \"a\\\"b\\\\c\\u000a\xc3\xa4\"}\n  ],\n  \"regions\": "
            "[]\n}\n");
}

TEST(NamesTable, SaysWhatTheFileCallsAGroup) {
  Groups groups;
  groups.boundary_names = {"inner wall"};
  const SideFile table = names_table(groups, {"inner_wall"}, {});
  EXPECT_NE(table.bytes.find(R"({"id": 1, "name": "inner wall", "tag": "inner_wall"})"), std::string::npos);
}

TEST(PlainNames, WordsStayAsTheyAre) {
  const NameList words{"wall", "in-let.2", "_x", "curve_0"};
  EXPECT_EQ(plain_names(words), words);
  EXPECT_EQ(renamed_loss(words, words), "");
}

TEST(PlainNames, WhatReadersPartWordsByIsReplaced) {
  EXPECT_EQ(plain_names({"outer wall", "a,b/c", "\"q\"", "x*y;z", "---", "2nd", ""}),
            (NameList{"outer_wall", "a_b_c", "_q_", "x_y_z", "_---", "_2nd", "_"}));
}

TEST(PlainNames, ALetterOfManyBytesIsOne) { EXPECT_EQ(plain_names({"S\u00fcd"}), (NameList{"S_d"})); }

TEST(PlainNames, NamesDoNotFallTogether) {
  EXPECT_EQ(plain_names({"a b", "a_b", "a,b", "taken"}, {{"taken"}}), (NameList{"a_b_2", "a_b", "a_b_3", "taken_2"}));
}

TEST(PlainNames, LongNamesAreCutAndStayDifferent) {
  const NameList names{"abcdefgh", "abcdefgi", "abcd", "ABCD"};
  EXPECT_EQ(plain_names(names, {{}, 4, false}), (NameList{"ab_2", "ab_3", "abcd", "ABCD"}));
  EXPECT_EQ(plain_names(names, {{}, 4, true}), (NameList{"ab_2", "ab_3", "abcd", "AB_4"}));
  EXPECT_EQ(plain_names({"All"}, {{"ALL"}, 0, true}), (NameList{"All_2"}));
  EXPECT_EQ(renamed_loss({"abcde"}, {"abcd"}, {{}, 4, false}),
            "1 name is written in at most 4 plain letters: \"abcde\" as abcd");
}

TEST(PlainNames, LossNamesTheFirstFew) {
  EXPECT_EQ(renamed_loss({"a b", "c"}, {"a_b", "c"}), "1 name is written in plain letters: \"a b\" as a_b");
  const NameList names{"1", "2", "3", "4"};
  EXPECT_EQ(renamed_loss(names, plain_names(names)),
            "4 names are written in plain letters: \"1\" as _1, \"2\" as _2, \"3\" as _3, ...");
}

TEST(PlainNames, RegionsAreLostWhereSomebodyNamedThem) {
  Groups groups;
  groups.region_names = {"block_0", "block_1"};
  groups.is_region_named = {false, false};
  EXPECT_EQ(region_loss(groups), "");
  groups.region_names = {"copper", "block_1", "air"};
  groups.is_region_named = {true, false, true};
  EXPECT_EQ(region_loss(groups), "2 region names are not stored");
  groups.region_names = {"plate"};
  groups.is_region_named = {true};
  EXPECT_EQ(region_loss(groups), "");
}

}  // namespace

}  // namespace quadrille::exports
