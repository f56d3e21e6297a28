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
  const graph::CandidateLayout layout = midpoint_layout(annulus(), report);
  EXPECT_TRUE(graph::faces_without_four_corners(layout.subdivision).empty());
  EXPECT_EQ(layout.subdivision.num_faces() % 3, 0);
}

TEST(MidpointLayout, WithoutAFieldOnlyMidpointAndAutoArePossible) {
  const TriMesh mesh = annulus();
  for (const LayoutChoice choice : {LayoutChoice::traced, LayoutChoice::quantized, LayoutChoice::t_mesh}) {
    Report report;
    EXPECT_THROW(layout_without_field(mesh, choice, report), UsageError);
  }
}

TEST(MidpointLayout, WhatAutoTakesInsteadOfSeparatricesIsAWarning) {
  const TriMesh mesh = annulus();
  Report asked, taken;
  const SeparatrixGraph first = layout_without_field(mesh, LayoutChoice::midpoint, asked);
  const SeparatrixGraph second = layout_without_field(mesh, LayoutChoice::automatic, taken);
  EXPECT_TRUE(asked.warnings().empty());
  EXPECT_EQ(first.certificate.reason, "");
  ASSERT_EQ(taken.warnings().size(), 1u);
  EXPECT_EQ(taken.warnings().front().code, "W-SEP-002");
  EXPECT_NE(second.certificate.reason, "");
}

TEST(MidpointLayout, TheCertificateCountsBlocksAndIndices) {
  Report report;
  const LayoutCertificate certificate = layout_without_field(annulus(), LayoutChoice::midpoint, report).certificate;
  EXPECT_EQ(certificate.method, LayoutMethod::midpoint);
  EXPECT_EQ(certificate.index_sum, 0);
  ASSERT_EQ(certificate.face_valence_histogram.size(), 1u);
  EXPECT_EQ(certificate.face_valence_histogram.front().corners, 4);
  EXPECT_EQ(certificate.largest_deviation_degrees, 0);
}

}  // namespace
}  // namespace quadrille::layout
