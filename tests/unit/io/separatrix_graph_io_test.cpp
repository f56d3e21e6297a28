#include <gtest/gtest.h>

#include <array>

#include "../samples.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using SeparatrixGraphIo = RoundTrip;

TEST_F(SeparatrixGraphIo, SeparatrixGraphSurvivesTheRoundTrip) {
  expect_same_bytes(samples::separatrix_graph());
  const SeparatrixGraph graph = read_stage<SeparatrixGraph>(read_input(path("second")));
  EXPECT_EQ(graph.nodes[4].kind, NodeKind::boundary);
  EXPECT_EQ(graph.arcs[6].pieces[0].curve, 4);
  EXPECT_EQ(graph.certificate.method, LayoutMethod::traced);
  EXPECT_EQ(graph.certificate.face_valence_histogram.at(0).faces, 2);
  EXPECT_EQ(stage_format(read_input(path("first"))), "separatrix-graph");
}

TEST_F(SeparatrixGraphIo, TheCertificateAndTheLinesAreKept) {
  SeparatrixGraph graph = samples::separatrix_graph();
  graph.certificate = {LayoutMethod::midpoint, "a strip winds onto itself", 3, {{3, 4}, {5, 6}}, 7, 8, 9, 10, 11.5};
  graph.lines = {{1, 2, LineKind::merged, {3, 5}}};
  graph.t_junctions = {4};
  expect_same_bytes(graph);
  const SeparatrixGraph read = read_stage<SeparatrixGraph>(read_input(path("second")));
  const LayoutCertificate& certificate = read.certificate;
  EXPECT_EQ(certificate.method, LayoutMethod::midpoint);
  EXPECT_EQ(certificate.reason, "a strip winds onto itself");
  ASSERT_EQ(certificate.face_valence_histogram.size(), 2u);
  EXPECT_EQ(certificate.face_valence_histogram[1].corners, 5);
  EXPECT_EQ(certificate.face_valence_histogram[1].faces, 6);
  EXPECT_EQ((std::array{certificate.index_sum, certificate.t_junctions, certificate.merged_lines,
                        certificate.collapsed_chords, certificate.shortened_spirals}),
            (std::array{3, 7, 8, 9, 10}));
  EXPECT_EQ(certificate.largest_deviation_degrees, 11.5);
  ASSERT_EQ(read.lines.size(), 1u);
  EXPECT_EQ((std::array{read.lines[0].origin, read.lines[0].end}), (std::array{1, 2}));
  EXPECT_EQ(read.lines[0].kind, LineKind::merged);
  EXPECT_EQ(read.lines[0].arcs, (std::vector<int>{3, 5}));
  EXPECT_EQ(read.t_junctions, std::vector<int>{4});
}

TEST_F(SeparatrixGraphIo, ASeparatrixGraphMayComeWithoutACertificate) {
  SeparatrixGraph graph = samples::separatrix_graph();
  graph.certificate = {};
  expect_same_bytes(graph);
  EXPECT_FALSE(read_stage<SeparatrixGraph>(read_input(path("second"))).certificate.method);
  EXPECT_EQ(bytes_of("second").find("certificate"), std::string::npos);
}

}  // namespace

}  // namespace quadrille::io
