#include "layout/quantized_layout.hpp"

#include <gtest/gtest.h>

#include "../support/hall_field.hpp"
#include "base/error.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::layout {
namespace {

using Options = std::vector<std::string>;

// Corners at (j, 0) and one irregular node, joined by arcs in this order. The strip lies between the first nodes.
struct OnAStrip : testing::Test {
  ArcGraph t_mesh;
  CriticalPoints points;
  std::vector<int> strip;

  void add_corner(double angle_degrees, int valence) {
    const int joint = static_cast<int>(points.corners.size());
    const Vec2 x{static_cast<double>(joint), 0};
    points.corners.push_back({joint, x, angle_degrees, valence, {joint + 10, joint}});
    add_node({x, NodeKind::corner, valence, joint, 0});
  }
  void add_irregular_node(NodeSource source) {
    CriticalPoint node;
    node.position = {0, 1};
    node.source = source;
    points.critical_points.push_back(node);
    add_node({node.position, NodeKind::irregular, 5});
  }
  void add_node(const GraphNode& node) {
    t_mesh.nodes.push_back(node);
    const int end = static_cast<int>(t_mesh.nodes.size()) - 1;
    if (end > 0) t_mesh.arcs.push_back({end - 1, end, false, 0, {}});
  }
  // The arcs between the nodes so far lie along the strip.
  void end_strip() {
    for (int a = 0; a < static_cast<int>(t_mesh.arcs.size()); ++a) strip.push_back(a);
  }
  void add_change(ChangeKind kind, int joint) {
    points.changes.push_back({kind, "", {}, {{points.corners[joint].position, 2, NodeLocation::corner}}});
  }
  Options remedies() const { return strip_remedies(t_mesh, strip, points); }
};

TEST_F(OnAStrip, ReflexCornersEmitNodesOfValenceFiveAndOthersOfThree) {
  add_corner(90, 1);
  add_corner(320, 4);
  end_strip();
  add_corner(270, 3);
  // 320 degrees: 3 (1.185 - 1)^2 - 4 (0.889 - 1)^2 = 0.05, 90 degrees: 2 (0.5 - 1)^2 = 0.5. The corner of 270 degrees
  // is not on the strip.
  EXPECT_EQ(remedies(), (Options{"--corner-valence 11:1=3", "--corner-valence 10:0=2"}));
}

TEST_F(OnAStrip, ValencesThatNoBlocksCanHaveAreLeftOut) {
  add_corner(182, 2);  // one block of 182 degrees
  add_corner(25, 1);   // two blocks of 12.5 degrees
  add_corner(190, 1);
  end_strip();
  EXPECT_EQ(remedies(), Options{});
}

TEST_F(OnAStrip, FourCornersWithTheLeastDefectAreEnough) {
  for (const double angle : {30, 100, 110, 60, 120, 90}) add_corner(angle, 1);
  end_strip();
  EXPECT_EQ(remedies(), (Options{"--corner-valence 14:4=2", "--corner-valence 12:2=2", "--corner-valence 11:1=2",
                                 "--corner-valence 15:5=2"}));
}

TEST_F(OnAStrip, ChoicesOnItAreUndoneFirst) {
  add_corner(182, 2);
  add_corner(182, 2);
  end_strip();
  add_corner(182, 2);
  add_change(ChangeKind::absorb, 2);
  add_change(ChangeKind::line, 2);
  EXPECT_EQ(remedies(), Options{}) << "they lie elsewhere";
  add_change(ChangeKind::line, 0);
  EXPECT_EQ(remedies(), Options{"--ties field"});
  add_change(ChangeKind::absorb, 1);
  EXPECT_EQ(remedies(), (Options{"--corner-absorb 0", "--ties field"}));
}

TEST_F(OnAStrip, NodesMoveBeforeCornersEmitOthers) {
  add_corner(270, 3);
  add_irregular_node(NodeSource::zero);
  end_strip();
  EXPECT_EQ(remedies(), (Options{"--place energy", "--corner-valence 10:0=2"}));
}

TEST_F(OnAStrip, NodesThatCannotMoveStay) {
  add_corner(182, 2);
  add_irregular_node(NodeSource::divide);
  end_strip();
  EXPECT_EQ(remedies(), Options{});
  points.critical_points[0].source = NodeSource::place;
  EXPECT_EQ(remedies(), Options{});
  points.critical_points[0].source = NodeSource::cluster;
  EXPECT_EQ(remedies(), Options{"--place energy"});
}

struct QuantizedHall : testing::Test {
  LayoutOptions options;
  Report report;

  graph::CandidateLayout quantized(double step, SimplifyLevel level) {
    const Field field = field_of_hall(step);
    const field::FieldEvaluator evaluator(field);
    options.simplify = level;
    options.trace.merge_angle = 0;  // the two lines that run head on stay two
    return quantized_layout(evaluator, corners_of_hall(field.mesh.face), options, report);
  }
  long long reported(const std::string& key) const {
    for (const auto& [name, value] : report.entries())
      if (name == key) return std::get<long long>(value);
    ADD_FAILURE() << key << " is not reported";
    return -1;
  }
};

TEST_F(QuantizedHall, IsConformingWithFourCornersEach) {
  const graph::CandidateLayout layout = quantized(0.1, SimplifyLevel::none);
  EXPECT_TRUE(layout.t_junctions.empty());
  EXPECT_EQ(graph::require_four_corners(layout.subdivision), 6);
  EXPECT_EQ(layout.num_built, 1);  // the T-mesh, whose lines are extended in place
}

TEST_F(QuantizedHall, ReportsItsLengths) {
  // A tenth of the diameter is one: the hall is two wide.
  quantized(0.1, SimplifyLevel::none);
  EXPECT_EQ(reported("quantize.faces"), 6);
  EXPECT_EQ(reported("quantize.rejected_merges"), 0);
  const double unit = 0.1 * std::sqrt(20.0);
  EXPECT_NEAR(static_cast<double>(reported("quantize.longest_arc")), 2 / unit, 1);
}

TEST_F(QuantizedHall, IsSimplifiedAsAsked) {
  EXPECT_EQ(quantized(0.1, SimplifyLevel::normal).subdivision.num_faces(), 4);
  EXPECT_EQ(reported("quantize.faces"), 6) << "before the simplification";
  options.max_deviation = 0.9 * degrees(deviation_of_hall(0.1));
  EXPECT_EQ(quantized(0.1, SimplifyLevel::normal).subdivision.num_faces(), 6);
}

TEST_F(QuantizedHall, LinesThatRunHeadOnMayBeMergedBefore) {
  options.trace.merge_angle = 15;
  const Field field = field_of_hall(0.1);
  const field::FieldEvaluator evaluator(field);
  options.simplify = SimplifyLevel::none;
  const graph::CandidateLayout layout = quantized_layout(evaluator, corners_of_hall(field.mesh.face), options, report);
  EXPECT_EQ(graph::require_four_corners(layout.subdivision), 4);
  EXPECT_EQ(layout.certificate.merged_lines, 1);
}

TEST_F(QuantizedHall, AFaceWithoutFourCornersIsNoPartOfATMesh) {
  const Field field = field_of_hall(0.1);
  const field::FieldEvaluator evaluator(field);
  CriticalPoints points = corners_of_hall(field.mesh.face);
  points.corners[2].valence = points.corners[7].valence = 1;  // eight corners, and no line
  EXPECT_THROW(quantized_layout(evaluator, points, options, report), ComputeError);
}

}  // namespace
}  // namespace quadrille::layout
