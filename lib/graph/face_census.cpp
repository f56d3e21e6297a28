#include "graph/face_census.hpp"

#include <map>

#include "graph/planar_faces.hpp"

namespace quadrille::graph {

std::vector<FaceCount> face_census(const SeparatrixGraph& graph) {
  std::map<int, int> corners2faces;
  for (const std::vector<int>& quarters : planar_faces(graph).quarters) ++corners2faces[num_corners(quarters)];
  std::vector<FaceCount> census;
  for (const auto& [corners, faces] : corners2faces) census.push_back({corners, faces});
  return census;
}

}  // namespace quadrille::graph
