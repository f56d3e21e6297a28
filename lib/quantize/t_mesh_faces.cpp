#include "quantize/t_mesh_faces.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace quadrille::quantize {
namespace {

bool is_four_sided(const std::vector<int>& quarters) {
  return graph::num_corners(quarters) == 4 &&
         std::all_of(quarters.begin(), quarters.end(), [](int q) { return q == 1 || q == 2; });
}

TFace sides_of(const std::vector<HalfEdge>& cycle, const std::vector<int>& quarters) {
  const size_t n = cycle.size();
  size_t first = 0;  // the half-edge after a corner
  while (quarters[(first + n - 1) % n] != 1) ++first;
  TFace face;
  int side = 0;
  for (size_t k = 0; k < n; ++k) {
    face[side].push_back(cycle[(first + k) % n]);
    if (quarters[(first + k) % n] == 1) ++side;
  }
  return face;
}

}  // namespace

std::vector<TFace> t_mesh_faces(const SeparatrixGraph& graph) {
  const graph::PlanarFaces faces = graph::planar_faces(graph);
  std::vector<TFace> all;
  for (size_t f = 0; f < faces.cycles.size(); ++f) {
    if (!is_four_sided(faces.quarters[f])) {
      const Vec2 place = graph::place_of(graph, faces.cycles[f]);
      throw ComputeError(
          fmt::format("the face of the T-mesh around ({:.6g}, {:.6g}) is not four-sided: {} arcs, the corners make {}",
                      place.x, place.y, faces.cycles[f].size(), graph::num_corners(faces.quarters[f])));
    }
    all.push_back(sides_of(faces.cycles[f], faces.quarters[f]));
  }
  if (faces.num_components > 1)
    throw ComputeError(fmt::format("the T-mesh falls into {} parts that nothing connects", faces.num_components));
  return all;
}

}  // namespace quadrille::quantize
