#include <gtest/gtest.h>

#include "../samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::separatrix_graph(), damage);
}

TEST(SeparatrixGraphCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](SeparatrixGraph&) {}), Rules{});
}

TEST(SeparatrixGraphCheck, SepR01SplinesAreSound) {
  EXPECT_EQ(broken([](auto& g) { g.splines[0].weights[0] = -1; }), Rules{"SEP-R01"});
  EXPECT_EQ(broken([](auto& g) { g.splines[0].knots.clear(); }), Rules{"SEP-R01"});
}
TEST(SeparatrixGraphCheck, SepR02NodesAndCurvesExist) {
  EXPECT_EQ(broken([](auto& g) { g.arcs[6].to = 6; }), Rules{"SEP-R02"});
  EXPECT_EQ(broken([](auto& g) { g.arcs[6].pieces[0].curve = 5; }), Rules{"SEP-R02"});
  EXPECT_EQ(broken([](auto& g) { g.nodes[0].curve = 4; }), Rules{"SEP-R02"});
}
TEST(SeparatrixGraphCheck, SepR03LinesExist) {
  EXPECT_EQ(broken([](auto& g) { g.lines[0].arcs = {7}; }), Rules{"SEP-R03"});
  EXPECT_EQ(broken([](auto& g) { g.t_junctions = {-1}; }), Rules{"SEP-R03"});
}
TEST(SeparatrixGraphCheck, SepR04PiecesAreSound) {
  EXPECT_EQ(broken([](auto& g) { g.arcs[6].pieces.clear(); }), Rules{"SEP-R04"});
  EXPECT_EQ(broken([](auto& g) { g.arcs[6].pieces[0].t1 = 2; }), Rules{"SEP-R04"});
  EXPECT_EQ(broken([](auto& g) { g.arcs[6].is_boundary = true; }), Rules{"SEP-R04"});
  EXPECT_EQ(broken([](auto& g) { g.arcs[6].length = -1; }), Rules{"SEP-R04"});
}
TEST(SeparatrixGraphCheck, SepR05ArcsAreChains) {
  EXPECT_EQ(broken([](auto& g) { g.splines[0].poles[1] = {0.6, 1}; }), Rules{"SEP-R05"});
}
TEST(SeparatrixGraphCheck, SepR06BoundaryIsCovered) {
  EXPECT_EQ(broken([](auto& g) {
              g.arcs[6].is_boundary = true;  // along the lower side again, over what arc 1 covers
              g.arcs[6].to = 1;
              g.arcs[6].pieces[0] = {0, 0.5, 1};
              g.lines.clear();
            }).contains("SEP-R06"),
            true);
}
TEST(SeparatrixGraphCheck, SepR07NodeKindsFit) {
  EXPECT_EQ(broken([](auto& g) { g.nodes[4].kind = NodeKind::crossing; }), Rules{"SEP-R07"});
  EXPECT_EQ(broken([](auto& g) { g.nodes[4].t = 0.25; }), Rules{"SEP-R07"});
}
TEST(SeparatrixGraphCheck, SepR08LinesAreChains) {
  EXPECT_EQ(broken([](auto& g) { g.lines[0].end = 0; }), Rules{"SEP-R08"});
  EXPECT_EQ(broken([](auto& g) { g.lines[0].arcs.clear(); }), Rules{"SEP-R08"});
}
TEST(SeparatrixGraphCheck, SepR09ValencesAreArcs) {
  EXPECT_EQ(broken([](auto& g) {
              g.nodes[4].valence = 3;
              g.certificate = {};
            }),
            Rules{"SEP-R09"});
}
TEST(SeparatrixGraphCheck, SepR10Census) {
  // Without the line's end node on the upper side, that side is one arc and the line ends in the open.
  EXPECT_TRUE(broken([](auto& g) {
                g.arcs.pop_back();
                g.lines.clear();
              }).contains("SEP-R10"));
}

TEST(SeparatrixGraphCheck, SepR11CertificateIsSound) {
  EXPECT_EQ(broken([](auto& g) { g.certificate.merged_lines = -1; }), Rules{"SEP-R11"});
  EXPECT_EQ(broken([](auto& g) { g.certificate.largest_deviation_degrees = 200; }), Rules{"SEP-R11"});
  EXPECT_EQ(broken([](auto& g) { g.certificate.face_valence_histogram = {{4, 1}, {4, 1}}; }), Rules{"SEP-R11"});
}
TEST(SeparatrixGraphCheck, SepR12IndexSum) {
  EXPECT_EQ(broken([](auto& g) { g.certificate.index_sum = 3; }), Rules{"SEP-R12"});
}
TEST(SeparatrixGraphCheck, SepR13CensusIsThatOfTheGraph) {
  EXPECT_EQ(broken([](auto& g) { g.certificate.face_valence_histogram = {{4, 3}}; }), Rules{"SEP-R13"});
  EXPECT_EQ(broken([](auto& g) {
              g.certificate.face_valence_histogram = {{3, 1}, {4, 1}};
              g.certificate.method = LayoutMethod::t_mesh;
            }),
            Rules{"SEP-R13"});
  EXPECT_EQ(broken([](auto& g) {
              g.certificate.t_junctions = 1;
              g.certificate.method = LayoutMethod::t_mesh;
            }),
            Rules{"SEP-R13"});
}
TEST(SeparatrixGraphCheck, SepR14LayoutsConform) {
  const auto unequal = [](LayoutMethod method) {
    return broken([method](auto& g) {
      g.certificate.face_valence_histogram = {{3, 1}, {5, 1}};  // together as many as there are
      g.certificate.method = method;
    });
  };
  EXPECT_EQ(unequal(LayoutMethod::quantized), Rules{"SEP-R14"});
  EXPECT_EQ(unequal(LayoutMethod::t_mesh), Rules{});
}
TEST(SeparatrixGraphCheck, AGraphWithoutACertificateIsNotJudgedByOne) {
  EXPECT_EQ(broken([](auto& g) { g.certificate = {}; }), Rules{});
}

}  // namespace
}  // namespace quadrille::check
