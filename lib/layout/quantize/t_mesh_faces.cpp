#include "quantize/t_mesh_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "graph/face_corners.hpp"

namespace quadrille::quantize {
namespace {

// The sides of a face with four corners whose other sectors are half turns; else empty.
std::optional<TFace> sides_of(const graph::Subdivision& subdivision, int f) {
  const std::vector<HalfEdge> cycle = subdivision.cycle(f);
  const auto is_corner = [&](HalfEdge h) { return subdivision.quarters(h) == 1; };
  if (subdivision.num_corners(f) != 4 || !std::all_of(cycle.begin(), cycle.end(), [&](HalfEdge h) {
        return is_corner(h) || subdivision.quarters(h) == 2;
      }))
    return std::nullopt;
  const size_t n = cycle.size();
  size_t first = 0;  // the half-edge after a corner
  while (!is_corner(cycle[(first + n - 1) % n])) ++first;
  TFace face;
  int side = 0;
  for (size_t k = 0; k < n; ++k) {
    const HalfEdge h = cycle[(first + k) % n];
    face[side].push_back(h);
    if (is_corner(h)) ++side;
  }
  return face;
}

}  // namespace

std::vector<TFace> t_mesh_faces(const graph::Subdivision& subdivision) {
  std::vector<TFace> all;
  for (int f = 0; f < subdivision.face_bound(); ++f) {
    std::optional<TFace> sides = sides_of(subdivision, f);
    if (!sides) {
      throw ComputeError(fmt::format("the face of the T-mesh around {} is not four-sided: {} arcs, {} corners",
                                     position_text(graph::middle_of_face(subdivision, f)), subdivision.cycle(f).size(),
                                     subdivision.num_corners(f)));
    }
    all.push_back(std::move(*sides));
  }
  if (subdivision.num_components() > subdivision.graph().face.num_regions())
    throw ComputeError(fmt::format("the T-mesh has {} unconnected parts", subdivision.num_components()));
  return all;
}

}  // namespace quadrille::quantize
