#include "quantize/t_mesh_faces.hpp"

#include <gtest/gtest.h>

#include "../support/square_t_mesh.hpp"
#include "base/error.hpp"
#include "graph/face_corners.hpp"

namespace quadrille::quantize {
namespace {

// Next to a node lines turn fast: the angle at which one stops at another, here 36 degrees, says nothing.
TEST(TMeshFaces, ATJunctionIsOneAtAnyAngle) {
  for (const double y : {0.02, 0.5, 0.98}) {
    const SeparatrixGraph graph = square_t_mesh::make({{{0.3, 0}, {0.3, 1}, 0, 2}, {{1, y}, {0.3, 1 - y}, 1, -1}});
    EXPECT_EQ(graph.t_junctions.size(), 1u);
    EXPECT_EQ(t_mesh_faces(graph::Subdivision(graph)).size(), 3u) << y;
  }
}

TEST(TMeshFaces, ALineThatEndsOnAnotherMakesATJunctionAndFourCorneredFaces) {
  const SeparatrixGraph graph = square_t_mesh::make(square_t_mesh::one_t);
  EXPECT_EQ(graph.t_junctions.size(), 1u);
  const std::vector<TFace> faces = t_mesh_faces(graph::Subdivision(graph));
  ASSERT_EQ(faces.size(), 3u);
  size_t half_edges = 0;
  for (const TFace& f : faces)
    for (const auto& side : f) half_edges += side.size();
  EXPECT_EQ(half_edges, 13u);  // four sides each, and one more where the T-junction is
  const std::vector<FaceCount> histogram = graph::face_valence_histogram(graph::Subdivision(graph));
  ASSERT_EQ(histogram.size(), 1u);
  EXPECT_EQ(histogram[0].corners, 4);
  EXPECT_EQ(histogram[0].faces, 3);
}

TEST(TMeshFaces, FacesOfOtherShapesAreNamed) {
  // The same graph, taken to have a corner of two quarters.
  SeparatrixGraph graph = square_t_mesh::make(square_t_mesh::one_t);
  graph.nodes[0].valence = 2;
  EXPECT_THROW(t_mesh_faces(graph::Subdivision(graph)), ComputeError);
}

}  // namespace
}  // namespace quadrille::quantize
