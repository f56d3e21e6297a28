#include "layout/certificate.hpp"

#include <gtest/gtest.h>

#include "../support/hall.hpp"
#include "../support/square_field.hpp"
#include "../support/square_t_mesh.hpp"

namespace quadrille::layout {
namespace {

constexpr double step = 0.1;

/// Crosses turned by `angle` from the axes.
Field turned_field(double angle) {
  return interpolated_field(square_mesh({-1, -2}, 6, 3), 1, [=](Vec2) { return cross_value(angle); });
}

/// The hall, some of whose four straight lines are said to be extended.
graph::CandidateLayout hall_with_extended(const std::vector<int>& lines) {
  graph::CandidateLayout layout = hall(step);
  for (const int line : lines) layout.lines[line].kind = LineKind::extended;
  return layout;
}

double deviation(const graph::CandidateLayout& layout, double angle) {
  const Field field = turned_field(angle);
  return deviation_of_extended_lines(field::FieldEvaluator(field), layout);
}

TEST(Certificate, OnlyExtendedLinesAreComparedWithTheField) {
  EXPECT_EQ(deviation(hall(step), 0.3), 0);
  EXPECT_NEAR(deviation(hall_with_extended({0}), 0.3), 0.3, 1e-9);
  EXPECT_NEAR(deviation(hall_with_extended({0, 1}), 0), 0, 1e-9);
}

TEST(Certificate, TheNearestOfFourDirectionsCounts) {
  EXPECT_NEAR(deviation(hall_with_extended({1}), half_pi + 0.2), 0.2, 1e-9);
  EXPECT_NEAR(deviation(hall_with_extended({1}), half_pi - 0.2), 0.2, 1e-9);
  EXPECT_NEAR(deviation(hall_with_extended({0, 1, 2, 3}), pi / 4), pi / 4, 1e-9);
}

TEST(Certificate, CountsTheFinishedGraph) {
  const Field field = turned_field(0.1);
  graph::CandidateLayout layout = hall_with_extended({0});
  layout.certificate.merged_lines = 5;
  layout.certificate.collapsed_chords = 3;
  Report report;
  certify(field::FieldEvaluator(field), LayoutMethod::quantized, layout, report);
  const LayoutCertificate& c = layout.certificate;
  EXPECT_EQ(c.method, LayoutMethod::quantized);
  EXPECT_EQ(c.index_sum, 4);  // of a disc: six corners of 90 and two of 270 degrees
  ASSERT_EQ(c.face_valence_histogram.size(), 1u);
  EXPECT_EQ(c.face_valence_histogram[0].corners, 4);
  EXPECT_EQ(c.face_valence_histogram[0].faces, 6);
  EXPECT_EQ(c.t_junctions, 0);
  EXPECT_EQ(c.merged_lines, 5) << "recorded before";
  EXPECT_EQ(c.collapsed_chords, 3) << "recorded before";
  EXPECT_NEAR(c.largest_deviation_degrees, degrees(0.1), 1e-7);
}

TEST(Certificate, ALargerDeviationFromBeforeStays) {
  const Field field = turned_field(0.1);
  graph::CandidateLayout layout = hall_with_extended({0});
  layout.certificate.largest_deviation_degrees = 30;
  Report report;
  certify(field::FieldEvaluator(field), LayoutMethod::traced, layout, report);
  EXPECT_EQ(layout.certificate.largest_deviation_degrees, 30);
}

TEST(Certificate, CountsTJunctionsAndReportsWhatItSays) {
  const Field field = turned_field(0);
  graph::CandidateLayout layout = graph::candidate_layout(square_t_mesh::make(square_t_mesh::one_t));
  Report report;
  certify(field::FieldEvaluator(field), LayoutMethod::t_mesh, layout, report);
  EXPECT_EQ(layout.certificate.t_junctions, 1);
  const auto reported = [&](const std::string& key) {
    for (const auto& [name, value] : report.entries())
      if (name == "certificate." + key) return true;
    return false;
  };
  for (const std::string key : {"method", "index_sum", "faces_of_4_corners", "t_junctions", "merged_lines",
                                "collapsed_chords", "shortened_spirals", "largest_deviation_degrees"})
    EXPECT_TRUE(reported(key)) << key;
  EXPECT_FALSE(reported("faces_of_5_corners"));
}

}  // namespace
}  // namespace quadrille::layout
