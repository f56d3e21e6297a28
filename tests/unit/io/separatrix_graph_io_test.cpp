#include <gtest/gtest.h>

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

TEST_F(SeparatrixGraphIo, ASeparatrixGraphMayComeWithoutACertificate) {
  SeparatrixGraph graph = samples::separatrix_graph();
  graph.certificate = {};
  expect_same_bytes(graph);
  EXPECT_FALSE(read_stage<SeparatrixGraph>(read_input(path("second"))).certificate.method);
  EXPECT_EQ(bytes_of("second").find("certificate"), std::string::npos);
}

}  // namespace

}  // namespace quadrille::io
