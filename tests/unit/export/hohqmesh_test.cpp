#include "export/hohqmesh.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "export/writers.hpp"
#include "periodic_row.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {

namespace {

HohqmeshModel model_of(const QuadMesh& mesh, const Frame& frame) {
  return hohqmesh_model(mesh, frame, Materials::lost);
}

using HohqmeshQuads = TwoQuadsTest<model_of>;

TEST_F(HohqmeshQuads, CornersCountFromOneInTheOrderOfTheElements) {
  EXPECT_EQ(model.corners, (std::vector<int>{0, 2, 12, 10, 4, 14}));
  EXPECT_EQ(model.elem_corners, (std::vector<std::array<int, 4>>{{1, 2, 3, 4}, {2, 5, 6, 3}}));
}

TEST_F(HohqmeshQuads, OnlyTheSideOffItsChordIsCurved) {
  EXPECT_EQ(model.is_curved,
            (std::vector<std::array<bool, 4>>{{false, false, false, false}, {false, false, true, false}}));
  mesh.nodes[7].x += 1e-3;  // the common side
  model = model_of(mesh, plane_frame(mesh.face));
  EXPECT_TRUE(model.is_curved[0][1]);
  EXPECT_TRUE(model.is_curved[1][3]);
}

TEST_F(HohqmeshQuads, SidesHaveTheNamesOfTheirBoundaries) {
  EXPECT_EQ(model.names, (std::vector<std::string>{"wall", "in___out", "curve_3"}));
  EXPECT_EQ(model.name(0, 0), "wall");
  EXPECT_EQ(model.name(1, 1), "in___out");
  EXPECT_EQ(model.name(0, 1), "---");
  EXPECT_EQ(model.name(0, 3), "curve_3");
}

TEST_F(HohqmeshQuads, AnEdgeHasBothItsElements) {
  ASSERT_EQ(model.edges.size(), 7u);
  int num_inner = 0;
  for (const HohqmeshEdge& edge : model.edges) {
    if (edge.other_elem < 0) {
      EXPECT_GE(model.boundary[edge.elem][edge.side], 0);
      continue;
    }
    ++num_inner;
    EXPECT_EQ(edge.elem, 0);
    EXPECT_EQ(edge.side, 1);
    EXPECT_EQ(edge.other_elem, 1);
    EXPECT_EQ(edge.other_side, 3);
  }
  EXPECT_EQ(num_inner, 1);
}

TEST_F(HohqmeshQuads, LossesAreTold) {
  const auto has_loss = [&](const std::string& part) {
    for (const std::string& loss : model.losses)
      if (loss.find(part) != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(has_loss("in & out"));  // renamed: one word
  EXPECT_EQ(model.side_files.size(), 1u);
  EXPECT_FALSE(has_loss("nodes inside elements"));
  mesh = two_quads_with_moved_middle();
  model = model_of(mesh, plane_frame(mesh.face));
  EXPECT_TRUE(has_loss("nodes inside elements are not stored"));
}

TEST_F(HohqmeshQuads, SidesRunInTheLocalCoordinatesDirection) {
  EXPECT_EQ(hohqmesh_side(mesh, 1, 0), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(hohqmesh_side(mesh, 1, 1), (std::vector<int>{4, 9, 14}));
  EXPECT_EQ(hohqmesh_side(mesh, 1, 2), (std::vector<int>{12, 13, 14}));
  EXPECT_EQ(hohqmesh_side(mesh, 1, 3), (std::vector<int>{2, 7, 12}));
}

TEST_F(HohqmeshQuads, PointsLieInTheFrame) {
  // Chebyshev-Lobatto points of order 2 are those of Gauss, Lobatto and Legendre.
  model = model_of(mesh, upright_frame());
  for (int n = 0; n < 15; ++n) {
    const std::array<double, 3> expected = upright_frame().at(mesh.nodes[n]);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(model.points[n][axis], expected[axis], 1e-15);
  }
}

TEST(HohqmeshIsm, TwoQuadsWordByWord) {
  const QuadMesh mesh = two_quads();
  const Exported exported = hohqmesh_ism(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes,
            "ISM-V2\n6 7 2 2\n"
            "0 0 0\n2 0 0\n2 2 0\n0 2 0\n4 0 0\n4 2 0\n"
            "1 2 1 0 1 0\n2 3 1 2 2 4\n3 4 1 0 3 0\n4 1 1 0 4 0\n2 5 2 0 1 0\n5 6 2 0 2 0\n6 3 2 0 3 0\n"
            "1 2 3 4\n0 0 0 0\nwall --- wall curve_3\n"
            "2 5 6 3\n0 0 1 0\n2 2 0\n3 2.5 0\n4 2 0\nwall in___out wall ---\n");
  ASSERT_EQ(exported.losses.size(), 2u);
  EXPECT_EQ(exported.losses[0], "1 name is written in plain letters: \"in & out\" as in___out");
  EXPECT_EQ(exported.losses[1], "2 region names are not stored");
  ASSERT_EQ(exported.side_files.size(), 1u);
  EXPECT_NE(exported.side_files[0].bytes.find("\"tag\": \"in___out\""), std::string::npos);
}

TEST(HohqmeshIsm, ThePageShowsWhatIsWritten) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const std::string text = hohqmesh_ism(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(page("hohqmesh.md").find("```\n" + text + "```\n"), std::string::npos);
}

TEST(HohqmeshIsm, TellsEdgesWithTheSameEndsApart) {
  const QuadMesh mesh = ring_of_two_quads();
  EXPECT_EQ(hohqmesh_model(mesh, plane_frame(mesh.face), Materials::lost).edges.size(), 6u);
}

TEST(HohqmeshIsm, SaysHowFarTheInteriorMoves) {
  const QuadMesh mesh = two_quads_with_moved_middle();
  const std::vector<std::string> losses = hohqmesh_ism(mesh, plane_frame(mesh.face)).losses;
  ASSERT_EQ(losses.size(), 3u);
  EXPECT_NE(losses[1].find("moves them by up to 0.28 (0.056 of the diameter)"), std::string::npos) << losses[1];
}

/// The second quad turned by a quarter each time: its side of number 1 to 4 meets side 2 of the first one.
QuadMesh turned(int quarters) {
  QuadMesh mesh = two_quads();
  const std::vector<int> ids(mesh.elem_nodes.begin() + 9, mesh.elem_nodes.end());
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      int a = i, b = j;
      for (int k = 0; k < quarters; ++k) {
        const int old = a;
        a = 2 - b;
        b = old;
      }
      mesh.elem_nodes[9 + 3 * j + i] = ids[3 * b + a];
    }
  for (QuadBoundaryEdge& e : mesh.boundary_edges)
    if (e.elem == 1) e.side = (e.side + 4 - quarters) % 4;
  return mesh;
}

TEST(HohqmeshIsm, SignTellsOppositeSequences) {
  const std::vector<std::string> lines{"\n2 3 1 2 2 4\n", "\n2 3 1 2 2 3\n", "\n2 3 1 2 2 -2\n", "\n2 3 1 2 2 -1\n"};
  for (int quarters = 0; quarters < 4; ++quarters) {
    const QuadMesh mesh = turned(quarters);
    EXPECT_NE(hohqmesh_ism(mesh, plane_frame(mesh.face)).bytes.find(lines[quarters]), std::string::npos) << quarters;
  }
}

TEST(HohqmeshIsm, APeriodicEdgeLiesBetweenTheElementsOfBothSides) {
  const QuadMesh mesh = periodic_row(2);
  const Exported exported = hohqmesh_ism(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes,
            "ISM-V2\n6 6 2 1\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n"
            "1 2 1 0 1 0\n2 3 1 2 2 4\n3 4 1 0 3 0\n4 1 1 2 4 2\n2 5 2 0 1 0\n6 3 2 0 3 0\n"
            "1 2 3 4\n0 0 0 0\nlow --- high ---\n2 5 6 3\n0 0 0 0\nlow --- high ---\n");
  EXPECT_TRUE(exported.losses.empty());
}

TEST(HohqmeshIsm, UnevenNodesOfAStraightSideAreACurve) {
  QuadMesh mesh = two_quads();
  mesh.nodes[7].y = 1.25;  // the middle of the common side
  const HohqmeshModel model = hohqmesh_model(mesh, plane_frame(mesh.face), Materials::lost);
  EXPECT_TRUE(model.is_curved[0][1]);
  EXPECT_TRUE(model.is_curved[1][3]);
  EXPECT_FALSE(model.is_curved[0][0]);
}

TEST(HohqmeshIsm, OrderOneHasNoCurves) {
  const QuadMesh mesh = two_straight_quads();
  const std::string text = hohqmesh_ism(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(text.find("6 7 2 1\n"), std::string::npos);
  EXPECT_NE(text.find("1 2 3 4\n0 0 0 0\nwall"), std::string::npos);
  EXPECT_NE(text.find("2 5 6 3\n0 0 0 0\nwall"), std::string::npos);
}

TEST(AbaqusInp, TwoQuadsWordByWord) {
  const QuadMesh mesh = two_quads();
  EXPECT_EQ(abaqus_inp(mesh, plane_frame(mesh.face)).bytes,
            "*Heading\n File created by HOHQMesh\n"
            "*NODE\n1, 0, 0, 0\n2, 2, 0, 0\n3, 2, 2, 0\n4, 0, 2, 0\n5, 4, 0, 0\n6, 4, 2, 0\n"
            "*ELEMENT, type=CPS4, ELSET=Surface1\n1, 1, 2, 3, 4\n2, 2, 5, 6, 3\n"
            "** ***** HOHQMesh boundary information ***** **\n** mesh polynomial degree = 2\n"
            "**  1 2 3 4\n**  0 0 0 0\n"
            "**  2 5 6 3\n**  0 0 1 0\n**  2 2 0\n**  3 2.5 0\n**  4 2 0\n"
            "** curve_3 --- wall wall\n** --- in___out wall wall\n");
}

TEST(AbaqusInp, ThePageShowsWhatIsWritten) {
  const QuadMesh mesh = two_quads_of_the_pages();
  const std::string text = abaqus_inp(mesh, plane_frame(mesh.face)).bytes;
  EXPECT_NE(page("abaqus.md").find("```\n" + text + "```\n"), std::string::npos);
}

TEST(AbaqusInp, RefusesEdgesThatP4estCannotTellApart) {
  const QuadMesh mesh = ring_of_two_quads();
  EXPECT_THROW(abaqus_inp(mesh, plane_frame(mesh.face)), ComputeError);
}

TEST(AbaqusInp, PeriodicSidesHaveTheSameCornersAndTheirOwnInComments) {
  const QuadMesh mesh = periodic_row(3);
  const Exported exported = abaqus_inp(mesh, plane_frame(mesh.face));
  EXPECT_EQ(exported.bytes,
            "*Heading\n File created by HOHQMesh\n"
            "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 2, 0, 0\n6, 2, 1, 0\n7, 3, 0, 0\n8, 3, 1, 0\n"
            "*ELEMENT, type=CPS4, ELSET=Surface1\n1, 1, 2, 3, 4\n2, 2, 5, 6, 3\n3, 5, 1, 4, 6\n"
            "** ***** HOHQMesh boundary information ***** **\n** mesh polynomial degree = 1\n"
            "**  1 2 3 4\n**  0 0 0 0\n**  2 5 6 3\n**  0 0 0 0\n**  5 7 8 6\n**  0 0 0 0\n"
            "** --- --- low high\n** --- --- low high\n** --- --- low high\n");
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("other programs read wrong quads along \"left\" and \"right\""), std::string::npos);
}

TEST(AbaqusInp, PeriodicSidesThatP4estCouldNotDistinguishAreReported) {
  const QuadMesh mesh = periodic_row(2);
  const Exported exported = abaqus_inp(mesh, plane_frame(mesh.face));
  EXPECT_NE(exported.bytes.find("\n2, 2, 5, 6, 3\n"), std::string::npos);
  EXPECT_NE(exported.bytes.find("\n** left --- low high\n** --- right low high\n"), std::string::npos);
  ASSERT_EQ(exported.losses.size(), 1u);
  EXPECT_NE(exported.losses[0].find("p4est identifies edges by their ends"), std::string::npos);
}

TEST(AbaqusInp, NamesAreWrittenInLettersThatReadersTake) {
  const QuadMesh mesh = two_quads();
  const Exported exported = abaqus_inp(mesh, plane_frame(mesh.face));
  ASSERT_EQ(exported.side_files.size(), 1u);
  EXPECT_EQ(exported.side_files[0].name.ending, ".names.json");
  EXPECT_EQ(exported.losses.size(), 2u);
}

}  // namespace

}  // namespace quadrille::exports
