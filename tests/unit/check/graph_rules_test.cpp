#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "../samples.hpp"
#include "check/rules.hpp"

namespace quadrille::check {

namespace {

/// A quarter of the unit circle.
Nurbs arc() { return {2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1}}; }

/// Two spans of degree 2 with a double knot between them.
Nurbs kinked() { return {2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}, {1, 1, 1, 1, 1}}; }

template <typename Change>
Nurbs with(Nurbs curve, const Change& change) {
  change(curve);
  return curve;
}

TEST(NurbsRules, SoundCurvesHaveNoFault) {
  for (const Nurbs& curve : {arc(), kinked()}) {
    EXPECT_EQ(structure_fault(curve), "");
    EXPECT_EQ(number_fault(curve), "");
  }
}

TEST(NurbsRules, ArraysThatDoNotFitAreNamed) {
  EXPECT_EQ(structure_fault(with(arc(), [](Nurbs& c) { c.degree = 26; })), "degree 26 is outside 1 to 25");
  EXPECT_EQ(structure_fault(with(arc(), [](Nurbs& c) { c.degree = 3; })), "3 poles are too few for degree 3");
  EXPECT_EQ(structure_fault(with(arc(), [](Nurbs& c) { c.weights.pop_back(); })), "2 weights for 3 poles");
  EXPECT_EQ(structure_fault(with(arc(), [](Nurbs& c) { c.knots.pop_back(); })), "5 knots for 3 poles of degree 2");
}

TEST(NurbsRules, NumbersThatNoCurveHasAreNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.poles[1].y = nan; })), "pole 1 is not finite");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.weights[2] = 0; })), "weight 2 is not positive");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.weights[2] = 2e8; })),
            "weights 0.707 and 2e+08 differ by more than a factor of 1e+08");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.knots[0] = nan; })), "knot 0 is not finite");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.knots[5] = 0.5; })), "knot 5 is smaller than the one before");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.knots.assign(6, 0); })), "the domain is empty");
  EXPECT_EQ(number_fault(with(arc(), [](Nurbs& c) { c.knots[2] = 0.5; })), "the curve is not clamped at its ends");
  EXPECT_EQ(number_fault(with(kinked(),
                              [](Nurbs& c) {
                                c.knots = {0, 0, 0, 1, 1, 1, 2, 2, 2};
                                c.poles.push_back({3, 3});
                                c.weights.push_back(1);
                              })),
            "the curve is broken at knot 3");
}

TEST(NurbsRules, PolesBeyondAThousandDiametersAreFar) {
  CadFace face;
  face.diameter = 1;
  face.curves = {arc()};
  EXPECT_FALSE(has_far_pole(arc(), face));
  EXPECT_FALSE(has_far_pole(with(arc(), [](Nurbs& c) { c.poles[1].x = 1000; }), face));
  EXPECT_TRUE(has_far_pole(with(arc(), [](Nurbs& c) { c.poles[1].x = 1002; }), face));
}

using Rule = void (*)(const ArcGraph&, Findings&);
using Texts = std::vector<std::string>;

/// What a rule finds in the sample, two blocks in a square, after some damage.
Texts findings_of(Rule rule, const std::function<void(SeparatrixGraph&)>& damage) {
  SeparatrixGraph graph = samples::separatrix_graph();
  damage(graph);
  Findings findings("RULE");
  rule(graph, findings);
  Texts texts;
  for (const Violation& v : findings.take()) texts.push_back(v.text);
  return texts;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(GraphRules, TheSampleSatisfiesAll) {
  for (const Rule rule :
       {splines_are_sound, graph_indices_exist, pieces_are_sound, arcs_are_chains, boundary_is_covered, node_kinds_fit})
    EXPECT_EQ(findings_of(rule, [](auto&) {}), Texts{});
}

TEST(GraphRules, SplinesNameTheirNumberAndFault) {
  const Texts texts = findings_of(splines_are_sound, [](auto& g) { g.splines[0].weights[0] = -1; });
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_TRUE(texts[0].starts_with("spline 0: ")) << texts[0];
}

TEST(GraphRules, EveryMissingIndexIsNamed) {
  const Texts texts = findings_of(graph_indices_exist, [](auto& g) {
    g.nodes[2].curve = 4;
    g.arcs[1].to = 6;
    g.arcs[3].pieces[0].curve = -1;
    g.arcs[6].pieces[0].curve = 5;
  });
  EXPECT_EQ(texts, (Texts{"node 2: curve 4 does not exist", "arc 1: an end node does not exist",
                          "arc 3: curve -1 does not exist", "arc 6: curve 5 does not exist"}));
}

TEST(GraphRules, PiecesLieInTheirCurves) {
  const auto piece = [](double t0, double t1) {
    return findings_of(pieces_are_sound, [=](auto& g) { g.arcs[6].pieces[0] = {4, t0, t1}; });
  };
  EXPECT_EQ(piece(0, 1 + 1e-13), Texts{}) << "round-off";
  EXPECT_EQ(piece(1, 0), Texts{}) << "backwards";
  EXPECT_EQ(piece(0, 1.25), Texts{"arc 6: parameters 0 to 1.25 are not a part of curve 4"});
  EXPECT_EQ(piece(0.5, 0.5), Texts{"arc 6: parameters 0.5 to 0.5 are not a part of curve 4"});
  EXPECT_EQ(piece(nan, 1).size(), 1u);
}

TEST(GraphRules, ArcsHavePiecesOfTheirKindAndNumbersAreFinite) {
  EXPECT_EQ(findings_of(pieces_are_sound, [](auto& g) { g.arcs[6].pieces.clear(); }), Texts{"arc 6 has no pieces"});
  EXPECT_EQ(findings_of(pieces_are_sound, [](auto& g) { g.arcs[2].length = -3; }),
            Texts{"arc 2: its length is negative"});
  EXPECT_EQ(findings_of(pieces_are_sound, [](auto& g) { g.arcs[2].is_boundary = false; }),
            Texts{"arc 2: boundary arcs follow CAD curves, inner arcs splines or the first side of an interface"});
  EXPECT_EQ(findings_of(pieces_are_sound, [](auto& g) { g.nodes[5].t = nan; }),
            Texts{"node 5 contains a number that is not finite"});
}

TEST(GraphRules, ChainsMeetWithinTheGapOfJoints) {
  const auto end_moved = [](double by) {
    return findings_of(arcs_are_chains, [=](auto& g) { g.splines[0].poles[1].x += by; });
  };
  EXPECT_EQ(end_moved(1.3e-5), Texts{});
  EXPECT_EQ(end_moved(1.5e-5).size(), 1u);
  EXPECT_EQ(end_moved(0.25), Texts{"arc 6 is broken: (0.75, 1) and (0.5, 1) do not meet"});
}

TEST(GraphRules, PlacesAreThoseOfTheCadModel) {
  const Texts texts = findings_of(arcs_are_chains, [](auto& g) {
    g.face.origin = {100, 200};
    g.splines[0].poles[1].x = 0.75;
  });
  EXPECT_EQ(texts, Texts{"arc 6 is broken: (100.75, 201) and (100.5, 201) do not meet"});
}

TEST(GraphRules, AnArcOfSeveralPiecesIsAChainToo) {
  const auto joined = [](std::vector<ArcPiece> pieces) {
    return findings_of(arcs_are_chains, [&](auto& g) {
      g.arcs[2] = {1, 5, true, 0, pieces};  // the right side and half of the upper one
    });
  };
  EXPECT_EQ(joined({{1, 0, 1}, {2, 0, 0.5}}), Texts{});
  EXPECT_EQ(joined({{1, 0, 1}, {2, 0.25, 0.5}}).size(), 1u);
  EXPECT_EQ(joined({{2, 0, 0.5}, {1, 0, 1}}).size(), 3u);
}

TEST(GraphRules, ASplineFarFromTheFaceIsNamed) {
  const Texts texts = findings_of(arcs_are_chains, [](auto& g) {
    g.splines[0] = {2, {0, 0, 0, 1, 1, 1}, {{0.5, 0}, {1e6, 0.5}, {0.5, 1}}, {1, 1, 1}};
  });
  EXPECT_EQ(texts, Texts{"spline 0 has a pole farther out than 1000 diameters"});
}

TEST(GraphRules, BoundaryArcsCoverEachCurveExactlyOnce) {
  EXPECT_EQ(findings_of(boundary_is_covered, [](auto& g) { g.arcs[1].pieces[0].t0 = 0.625; }),
            Texts{"the boundary arcs do not cover curve 0 exactly once, near parameter 0.5"});
  EXPECT_EQ(findings_of(boundary_is_covered, [](auto& g) { g.arcs[2].pieces[0].t1 = 0.75; }),
            Texts{"the boundary arcs do not cover curve 1 exactly once, near parameter 0.75"});
  EXPECT_EQ(findings_of(boundary_is_covered, [](auto& g) { g.arcs.push_back(g.arcs[5]); }),
            Texts{"the boundary arcs do not cover curve 3 exactly once, near parameter 1"});
  EXPECT_EQ(findings_of(boundary_is_covered, [](auto& g) { g.arcs.pop_back(); }), Texts{}) << "an inner arc";
}

TEST(GraphRules, KindsOfNodesFitTheirCurves) {
  const std::string kinds = "node 4: boundary nodes and corners name a CAD curve, crossings do not";
  EXPECT_EQ(findings_of(node_kinds_fit, [](auto& g) { g.nodes[4].curve = -1; }), Texts{kinds});
  EXPECT_EQ(findings_of(node_kinds_fit, [](auto& g) { g.nodes[4].kind = NodeKind::crossing; }), Texts{kinds});
  EXPECT_EQ(findings_of(node_kinds_fit, [](auto& g) { g.nodes[4].valence = 65; }),
            Texts{"node 4: valence 65 is outside 0 to 64"});
  EXPECT_EQ(findings_of(node_kinds_fit,
                        [](auto& g) {
                          g.nodes[4].position = {0.5, 0.125};
                        }),
            Texts{"node 4 does not lie on curve 0 at its parameter, near (0.5, 0.125)"});
  EXPECT_EQ(findings_of(node_kinds_fit, [](auto& g) { g.nodes[4].t = 1.5; }).size(), 1u);
}

TEST(GraphRules, ManyFaultsAreCounted) {
  const Texts texts = findings_of(pieces_are_sound, [](auto& g) {
    for (GraphArc& arc : g.arcs) arc.length = -1;
  });
  ASSERT_EQ(texts.size(), 6u);
  EXPECT_EQ(texts[5], "and 2 more violations");
}

}  // namespace

}  // namespace quadrille::check
