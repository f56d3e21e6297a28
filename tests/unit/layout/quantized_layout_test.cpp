#include "layout/quantized_layout.hpp"

#include <gtest/gtest.h>

#include "../support/hall_field.hpp"
#include "base/error.hpp"
#include "graph/face_corners.hpp"

namespace quadrille::layout {
namespace {

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
