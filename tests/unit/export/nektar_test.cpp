#include <gtest/gtest.h>

#include <algorithm>

#include "export/writers.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

std::string xml(const QuadMesh& mesh) { return nektar_xml(mesh, plane_frame(mesh.face)).bytes; }

/// From the first `from` to the next `to`, both included.
std::string cut(const std::string& text, const std::string& from, const std::string& to) {
  const auto begin = text.find(from), end = text.find(to, begin);
  return begin == std::string::npos || end == std::string::npos ? "" : text.substr(begin, end + to.size() - begin);
}

TEST(Nektar, TwoQuadsInFull) {
  // Written by hand from the description of the format: vertices and edges as a loop over the quads meets them, edges
  // parallel along chords, composites numbered from 1.
  EXPECT_EQ(xml(two_quads()), R"(<?xml version="1.0" encoding="utf-8"?>
<NEKTAR>
  <GEOMETRY DIM="2" SPACE="2">
    <VERTEX>
      <V ID="0">0 0 0</V>
      <V ID="1">2 0 0</V>
      <V ID="2">2 2 0</V>
      <V ID="3">0 2 0</V>
      <V ID="4">4 0 0</V>
      <V ID="5">4 2 0</V>
    </VERTEX>
    <EDGE>
      <E ID="0">0 1</E>
      <E ID="1">1 2</E>
      <E ID="2">3 2</E>
      <E ID="3">0 3</E>
      <E ID="4">1 4</E>
      <E ID="5">4 5</E>
      <E ID="6">2 5</E>
    </EDGE>
    <ELEMENT>
      <Q ID="0">0 1 2 3</Q>
      <Q ID="1">4 5 6 1</Q>
    </ELEMENT>
    <CURVED>
      <E ID="0" EDGEID="6" NUMPOINTS="3" TYPE="GaussLobattoLegendre">2 2 0  3 2.5 0  4 2 0</E>
    </CURVED>
    <COMPOSITE>
      <C ID="1" NAME="wall"> E[0,2,4,6] </C>
      <C ID="2" NAME="in &amp; out"> E[5] </C>
      <C ID="3" NAME="curve_3"> E[3] </C>
      <C ID="4" NAME="left"> Q[0] </C>
      <C ID="5" NAME="right"> Q[1] </C>
    </COMPOSITE>
    <DOMAIN>
      <D ID="0"> C[4-5] </D>
    </DOMAIN>
  </GEOMETRY>
  <EXPANSIONS>
    <E COMPOSITE="C[4-5]" NUMMODES="3" TYPE="MODIFIED" FIELDS="u" />
  </EXPANSIONS>
</NEKTAR>
)");
}

TEST(Nektar, ThePageShowsWhatIsWritten) {
  EXPECT_NE(page("nektar.md").find("```xml\n" + xml(two_quads_of_the_pages()) + "```\n"), std::string::npos);
}

TEST(Nektar, WhatTheSidesDoNotTellIsAFaceAndAllItsEdgesAreCurved) {
  EXPECT_EQ(cut(xml(two_quads_with_moved_middle()), "    <CURVED>", "</CURVED>"), R"(    <CURVED>
      <E ID="0" EDGEID="1" NUMPOINTS="3" TYPE="GaussLobattoLegendre">2 0 0  2 1 0  2 2 0</E>
      <E ID="1" EDGEID="4" NUMPOINTS="3" TYPE="GaussLobattoLegendre">2 0 0  3 0 0  4 0 0</E>
      <E ID="2" EDGEID="5" NUMPOINTS="3" TYPE="GaussLobattoLegendre">4 0 0  4 1 0  4 2 0</E>
      <E ID="3" EDGEID="6" NUMPOINTS="3" TYPE="GaussLobattoLegendre">2 2 0  3 2.5 0  4 2 0</E>
      <F ID="4" FACEID="1" NUMPOINTS="9" TYPE="GaussLobattoLegendre">)"
                                                                                  "2 0 0  3 0 0  4 0 0  "
                                                                                  "2 1 0  3.125 1.5 0  4 1 0  "
                                                                                  "2 2 0  3 2.5 0  4 2 0</F>\n"
                                                                                  "    </CURVED>");
}

TEST(Nektar, AnElementStartsWhereBothOfItsDirectionsBegin) {
  QuadMesh mesh = two_quads_with_moved_middle();
  // The second quad from its upper right corner on, and what is on its sides with it.
  std::reverse(mesh.elem_nodes.begin() + 9, mesh.elem_nodes.end());
  mesh.boundary_edges = {{0, 0, 0}, {1, 2, 0}, {1, 3, 1}, {1, 0, 2}, {0, 2, 2}, {0, 3, 3}};
  const std::string text = xml(mesh);
  // It meets its edges from its start on, which is the same as in two_quads().
  EXPECT_EQ(cut(text, "    <EDGE>", "</ELEMENT>"), cut(xml(two_quads_with_moved_middle()), "    <EDGE>", "</ELEMENT>"));
  EXPECT_EQ(cut(text, "<F", "</F>"), cut(xml(two_quads_with_moved_middle()), "<F", "</F>"));
  EXPECT_EQ(cut(text, "    <COMPOSITE>", "</COMPOSITE>"), cut(xml(two_quads()), "    <COMPOSITE>", "</COMPOSITE>"));
}

TEST(Nektar, AnEdgeThatIsStraightButForRoundOffIsNotACurve) {
  QuadMesh mesh = two_quads();
  mesh.nodes[1].y = 1e-10;  // the middle of edge 0, of length 2
  EXPECT_EQ(xml(mesh), xml([&] {
              QuadMesh flat = mesh;
              flat.nodes[1].y = 0;
              return flat;
            }()));
  mesh.nodes[1].y = 3e-10;
  EXPECT_NE(xml(mesh).find("EDGEID=\"0\""), std::string::npos);
}

TEST(Nektar, AStraightLineWalkedAtVaryingSpeedIsACurve) {
  QuadMesh mesh = two_quads();
  mesh.nodes[1].x = 1.25;  // the middle of edge 0
  EXPECT_NE(xml(mesh).find(R"(EDGEID="0" NUMPOINTS="3" TYPE="GaussLobattoLegendre">0 0 0  1.25 0 0  2 0 0</E>)"),
            std::string::npos);
}

TEST(Nektar, OrderOneHasNoCurves) {
  const std::string text = xml(two_straight_quads());
  EXPECT_EQ(text.find("CURVED"), std::string::npos);
  EXPECT_NE(text.find("NUMMODES=\"2\""), std::string::npos);
}

TEST(Nektar, AllDigitsAndTheOriginAreThere) {
  QuadMesh mesh = two_quads();
  mesh.nodes[0] = {0.1, 1.0 / 3};
  mesh.face.origin = {-1, 0};
  EXPECT_NE(xml(mesh).find("<V ID=\"0\">-0.9 0.3333333333333333 0</V>"), std::string::npos);
}

TEST(Nektar, NamesAreEscapedAndControlCharactersAreSaidToBeLost) {
  QuadMesh mesh = two_quads();
  mesh.block_names = {"<a> \"b\" 'c'", "two\nlines"};
  const Exported exported = nektar_xml(mesh, plane_frame(mesh.face));
  EXPECT_NE(exported.bytes.find(R"(NAME="&lt;a&gt; &quot;b&quot; 'c'")"), std::string::npos);
  EXPECT_NE(exported.bytes.find(R"(NAME="two_lines")"), std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("1 name"), std::string::npos);
  EXPECT_TRUE(nektar_xml(two_quads(), plane_frame(mesh.face)).losses.empty());
}

/// Four unit squares, of which the left and the right side of [0, 2]^2 are periodic. On the left the lower square is
/// met before the upper one, on the right after it.
QuadMesh four_quads() {
  QuadMesh mesh;
  mesh.order = 1;
  mesh.face.diameter = 3;
  mesh.face.curves.resize(4);
  mesh.face.curve_names = {"low", "right", "high", "left"};
  mesh.face.periodic_pairs = {{{3, 1}, 0, {2, 0}}};
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) mesh.nodes.push_back({1.0 * i, 1.0 * j});
  for (const int first : {0, 3, 4, 1})
    for (const int node : {0, 1, 3, 4}) mesh.elem_nodes.push_back(first + node);
  mesh.elem_block = {0, 0, 0, 0};
  mesh.block_names = {"gas"};
  mesh.boundary_edges = {{0, 0, 0}, {3, 0, 0}, {3, 1, 1}, {2, 1, 1}, {2, 2, 2}, {1, 2, 2}, {1, 3, 3}, {0, 3, 3}};
  return mesh;
}

TEST(Nektar, EdgesOfPeriodicCompositesAreInTheSameOrder) {
  const QuadMesh mesh = four_quads();
  const Exported exported = nektar_xml(mesh, plane_frame(mesh.face));
  EXPECT_NE(exported.bytes.find(R"(<C ID="2" NAME="right"> E[11,8] </C>)"), std::string::npos);
  EXPECT_NE(exported.bytes.find(R"(<C ID="4" NAME="left"> E[3,6] </C>)"), std::string::npos);
  EXPECT_TRUE(exported.losses.empty());
}

TEST(Nektar, ACompositeWithOtherEdgesIsNotPeriodic) {
  QuadMesh mesh = four_quads();
  mesh.face.curve_names[2] = "right";
  const Exported exported = nektar_xml(mesh, plane_frame(mesh.face));
  EXPECT_NE(exported.bytes.find(R"(<C ID="2" NAME="right"> E[5,8-9,11] </C>)"), std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("(a composite has periodic curves of one motion only)"), std::string::npos);
}

TEST(Nektar, SpaceHasThreeDimensionsOnlyWhereItNeedsThem) {
  const QuadMesh mesh = two_quads();
  const std::string text = nektar_xml(mesh, upright_frame()).bytes;
  EXPECT_NE(text.find("<GEOMETRY DIM=\"2\" SPACE=\"3\">"), std::string::npos);
  EXPECT_NE(text.find("<V ID=\"5\">7 4 2</V>"), std::string::npos);
  EXPECT_NE(text.find(">7 2 2  7 3 2.5  7 4 2</E>"), std::string::npos);
  // Seen from below: two dimensions would turn every quad over.
  const std::string below = nektar_xml(mesh, {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}).bytes;
  EXPECT_NE(below.find("SPACE=\"3\""), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
