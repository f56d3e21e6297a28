#include "triangulate/size_triangles.hpp"

#include <algorithm>
#include <array>

#include "curve/pole_box.hpp"
#include "triangulate/delaunay.hpp"

namespace quadrille::triangulate {
namespace {

/// A frame so far away that the triangles at it leave out hardly anything of the convex hull.
constexpr double frame_distance = 1e3;
constexpr int frame_corners = 4;

void insert_frame(const std::vector<Vec2>& points, ConstrainedDelaunay& delaunay) {
  curve::PoleBox box{points[0], points[0]};
  for (const Vec2 point : points) box.extend({point, point});
  const auto& [low, high] = box;
  const double reach = frame_distance * std::max({high.x - low.x, high.y - low.y, 1e-300});
  const std::array<Vec2, frame_corners> corners{Vec2{low.x - reach, low.y - reach},
                                                {high.x + reach, low.y - reach},
                                                {high.x + reach, high.y + reach},
                                                {low.x - reach, high.y + reach}};
  for (const Vec2 corner : corners) delaunay.insert(corner);
  for (int k = 0; k < frame_corners; ++k) delaunay.constrain(k, (k + 1) % frame_corners);
}

}  // namespace

void add_size_triangles(SizeSources& sources, const std::vector<Vec2>& positions) {
  if (sources.points.size() < 3) return;
  ConstrainedDelaunay delaunay;
  insert_frame(positions, delaunay);
  std::vector<const SizeBall*> vertices(frame_corners, nullptr);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const SizeBall& point = sources.points[i];
    const auto vertex = static_cast<std::size_t>(delaunay.insert(positions[i]));
    if (vertex == vertices.size())
      vertices.push_back(&point);
    else if (point.size < vertices[vertex]->size)
      vertices[vertex] = &point;  // of two at one place the finer one
  }
  for (const DelaunayTriangle& triangle : delaunay.triangles()) {
    SizeTriangle found;
    bool is_inside = true;
    for (int k = 0; k < 3; ++k) {
      const SizeBall* point = vertices[triangle.vertices[k]];
      is_inside = is_inside && point;
      if (point) found.corners[k] = point->position, found.sizes[k] = point->size;
    }
    if (is_inside) sources.triangles.push_back(found);
  }
}

}  // namespace quadrille::triangulate
