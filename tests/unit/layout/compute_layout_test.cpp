#include "layout/compute_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../hand_made.hpp"
#include "../support/hall_field.hpp"
#include "base/error.hpp"
#include "graph/candidate_layout.hpp"
#include "trace/merged_lines.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::layout {
namespace {

/// A computation that succeeds from a tolerance on.
struct Computation {
  double sufficient;
  std::vector<double> tried = {};
  Report report = {};

  graph::CandidateLayout run(const LayoutOptions& options = {}) {
    return with_fine_tolerance(options, report, [this](const LayoutOptions& o) {
      tried.push_back(o.trace.tolerance);
      if (o.trace.tolerance > sufficient) throw trace::FamilyOrderError("they cross");
      return graph::candidate_layout(hand_made::cut_annulus(4));
    });
  }
};

TEST(FineTolerance, IsNotChangedWithoutNeed) {
  Computation c{1};
  c.run();
  EXPECT_EQ(c.tried.size(), 1u);
  EXPECT_TRUE(c.report.entries().empty());
}

TEST(FineTolerance, IsRefinedWhileLinesOfOneFamilyCrossAndReported) {
  Computation c{1.1e-12};
  EXPECT_EQ(c.run().subdivision.num_faces(), 4);
  ASSERT_EQ(c.tried.size(), 2u);
  EXPECT_NEAR(c.tried[1], 1e-12, 1e-20);
  ASSERT_EQ(c.report.entries().size(), 1u);
  EXPECT_EQ(c.report.entries().front().first, "layout.tolerance");
}

TEST(FineTolerance, IsNotRefinedBelowRoundOff) {
  Computation c{0};
  EXPECT_THROW(c.run(), trace::FamilyOrderError);
  EXPECT_EQ(c.tried.size(), 2u);
}

/// Two reflex corners, whose four lines cross once: six blocks, two of them thin.
struct ComputeLayout : testing::Test {
  Field field = field_of_hall(0.2);
  field::FieldEvaluator evaluator{field};
  CriticalPoints points = corners_of_hall(field.mesh.face);
  LayoutOptions options;
  Report report;

  SeparatrixGraph computed(LayoutChoice choice, SimplifyLevel level = SimplifyLevel::none) {
    options.layout = choice;
    options.trace.merge_angle = 0;  // the two lines that run head on stay two
    options.simplify = level;
    return compute_layout(evaluator, points, options, report);
  }
  bool reports(const std::string& key) const {
    const auto& entries = report.entries();
    return std::any_of(entries.begin(), entries.end(), [&](const auto& entry) { return entry.first == key; });
  }
  static int num_of(const SeparatrixGraph& graph, LineKind kind) {
    return static_cast<int>(
        std::count_if(graph.lines.begin(), graph.lines.end(), [&](const auto& line) { return line.kind == kind; }));
  }
};

int num_blocks(const SeparatrixGraph& graph) { return graph::require_four_corners(graph::Subdivision(graph)); }

TEST_F(ComputeLayout, TracedLinesRunToTheirEnds) {
  const SeparatrixGraph graph = computed(LayoutChoice::traced);
  EXPECT_EQ(graph.certificate.method, LayoutMethod::traced);
  EXPECT_EQ(num_blocks(graph), 6);
  EXPECT_EQ(num_of(graph, LineKind::traced), 4);
  EXPECT_FALSE(reports("layout.method")) << "nothing was chosen";
  EXPECT_TRUE(reports("subdivision.built"));
}

TEST_F(ComputeLayout, LinesOfATMeshStopAtEachOther) {
  const SeparatrixGraph graph = computed(LayoutChoice::t_mesh);
  EXPECT_EQ(graph.certificate.method, LayoutMethod::t_mesh);
  // The line of the lower corner has gone 0.2 where the other one arrives after 2.
  ASSERT_EQ(graph.t_junctions.size(), 1u);
  EXPECT_NEAR(distance(graph.nodes[graph.t_junctions[0]].position, {1, 1.2}), 0, 1e-9);
  EXPECT_EQ(graph.certificate.t_junctions, 1);
  EXPECT_EQ(num_of(graph, LineKind::extended), 0);
}

TEST_F(ComputeLayout, QuantizedLinesContinueWhereTheyStopped) {
  const SeparatrixGraph graph = computed(LayoutChoice::quantized);
  EXPECT_EQ(graph.certificate.method, LayoutMethod::quantized);
  EXPECT_TRUE(graph.t_junctions.empty());
  EXPECT_EQ(num_blocks(graph), 6);
  EXPECT_EQ(num_of(graph, LineKind::extended), 1);
  EXPECT_LT(graph.certificate.largest_deviation_degrees, 1e-3) << "all lines are straight";
}

TEST_F(ComputeLayout, AutomaticTakesTracedLinesThatMakeFewBlocks) {
  const SeparatrixGraph graph = computed(LayoutChoice::automatic);
  EXPECT_EQ(graph.certificate.method, LayoutMethod::traced);
  EXPECT_EQ(graph.certificate.reason, "");
  EXPECT_TRUE(reports("layout.method"));
  EXPECT_TRUE(report.warnings().empty());
}

TEST_F(ComputeLayout, SimplificationCollapsesTheThinStripOfEither) {
  for (const LayoutChoice choice : {LayoutChoice::traced, LayoutChoice::quantized}) {
    const SeparatrixGraph graph = computed(choice, SimplifyLevel::normal);
    EXPECT_EQ(num_blocks(graph), 4);
    EXPECT_EQ(graph.certificate.collapsed_chords, 1);
    EXPECT_NEAR(graph.certificate.largest_deviation_degrees, degrees(deviation_of_hall(0.2)), 0.1);
  }
}

TEST_F(ComputeLayout, NodesThatNoLineCanUseAreRefusedWithTheirPosition) {
  points.corners[0].valence = 0;
  for (const LayoutChoice choice : {LayoutChoice::traced, LayoutChoice::quantized, LayoutChoice::t_mesh}) try {
      computed(choice);
      FAIL() << "no exception";
    } catch (const ComputeError& error) {
      EXPECT_NE(std::string(error.what()).find("at (1, 0)"), std::string::npos) << error.what();
    }
}

TEST_F(ComputeLayout, WhereNodesCannotBeUsedAutomaticDividesTriangles) {
  points.corners[0].valence = 0;
  options.coarse_mesher = triangulate::coarse_triangles;
  const SeparatrixGraph graph = computed(LayoutChoice::automatic);
  EXPECT_EQ(graph.certificate.method, LayoutMethod::midpoint);
  EXPECT_EQ(report.warnings().size(), 1u);
}

TEST_F(ComputeLayout, WithoutACoarseMesherAutomaticStatesWhyThereIsNoLayout) {
  points.corners[0].valence = 0;
  try {
    computed(LayoutChoice::automatic);
    FAIL() << "no exception";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("at (1, 0)"), std::string::npos) << error.what();
  }
}

TEST_F(ComputeLayout, OptionsAreCheckedFirst) {
  options.max_lines = -1;
  EXPECT_THROW(computed(LayoutChoice::automatic), UsageError);
}

}  // namespace
}  // namespace quadrille::layout
