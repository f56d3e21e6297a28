#include "layout/midpoint_layout.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "graph/face_corners.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::layout {
namespace {

TriMesh annulus() {
  Report report;
  return triangulate::triangulate(testing_faces::annulus(), {}, report);
}

TEST(MidpointLayout, EveryFaceHasFourCorners) {
  Report report;
  const graph::CandidateLayout layout = midpoint_layout(annulus(), triangulate::coarse_triangles, report);
  EXPECT_TRUE(graph::faces_without_four_corners(layout.subdivision).empty());
  EXPECT_EQ(layout.subdivision.num_faces() % 3, 0);
}

TEST(MidpointLayout, WithoutAFieldOnlyMidpointAndAutoArePossible) {
  for (const LayoutChoice choice : {LayoutChoice::traced, LayoutChoice::quantized, LayoutChoice::t_mesh})
    EXPECT_THROW(reason_without_field(choice), UsageError);
  EXPECT_EQ(reason_without_field(LayoutChoice::midpoint), "");
  EXPECT_NE(reason_without_field(LayoutChoice::automatic), "");
}

TEST(MidpointLayout, AReasonIsAWarning) {
  Report report;
  graph::CandidateLayout layout = midpoint_layout(annulus(), triangulate::coarse_triangles, report);
  certify_midpoint(layout, "", report);
  EXPECT_TRUE(report.warnings().empty());
  EXPECT_EQ(layout.certificate.reason, "");
  certify_midpoint(layout, "the lines spiral", report);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings().front().code, "W-SEP-002");
  EXPECT_EQ(layout.certificate.reason, "the lines spiral");
}

TEST(MidpointLayout, TheCertificateCountsBlocksAndIndices) {
  Report report;
  graph::CandidateLayout layout = midpoint_layout(annulus(), triangulate::coarse_triangles, report);
  certify_midpoint(layout, "", report);
  EXPECT_EQ(layout.certificate.method, LayoutMethod::midpoint);
  EXPECT_EQ(layout.certificate.index_sum, 0);
  ASSERT_EQ(layout.certificate.face_valence_histogram.size(), 1u);
  EXPECT_EQ(layout.certificate.face_valence_histogram.front().corners, 4);
  EXPECT_EQ(layout.certificate.largest_deviation_degrees, 0);
}

}  // namespace
}  // namespace quadrille::layout
