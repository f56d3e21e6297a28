#include <gtest/gtest.h>

#include "square_samples.hpp"

namespace quadrille::draw {
namespace {

TEST(DrawSeparatrixGraph, SeparatricesShowLinesAndNodes) {
  const std::string svg = draw_stage(halved_square(), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "id=\"line-"), 1);
  EXPECT_EQ(count(svg, "<title>node "), 6);
}

TEST(DrawSeparatrixGraph, SeparatricesTellTheirCertificate) {
  SeparatrixGraph graph = halved_square();
  EXPECT_EQ(count(draw_stage(graph, {}), "index sum"), 0);
  graph.certificate.method = LayoutMethod::traced;
  graph.certificate.index_sum = 4;
  graph.certificate.face_valence_histogram = {{4, 2}};
  graph.certificate.largest_deviation_degrees = 2.34;
  EXPECT_EQ(count(draw_stage(graph, {}), "traced: 2 faces of 4 corners, index sum 4, turned by 2.3° at most"), 1);
}

TEST(DrawSeparatrixGraph, ArcsOfNoLineAreDrawnAllTheSame) {
  SeparatrixGraph graph = halved_square();
  graph.lines.clear();
  EXPECT_EQ(count(draw_stage(graph, {}), "<title>arc 6<"), 1);
}

}  // namespace
}  // namespace quadrille::draw
