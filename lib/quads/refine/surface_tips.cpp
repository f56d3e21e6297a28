#include "refine/surface_tips.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "surface/nurbs_surface.hpp"

namespace quadrille::refine {
namespace {

constexpr double degenerate = 1e-8;  ///< ratio of the lengths of the derivatives
constexpr double small_step = 1e-3;  ///< of the way to another vertex, on which normals of a smooth surface hardly turn
constexpr double least_turn = 0.05;  ///< radians

/// The normal beside a vertex where the parameters degenerate, on the way to another one; none where they do not. The
/// parameter along which the surface does not move there is that of the other vertex.
std::optional<Vec3> normal_beside(const NurbsSurface& surface, Vec2 vertex, Vec2 other) {
  const surface::SurfacePoint at = surface::evaluate(surface, vertex);
  const double along_u = norm(at.xu), along_v = norm(at.xv);
  if (std::min(along_u, along_v) > degenerate * std::max(along_u, along_v)) return std::nullopt;
  Vec2 uv = vertex + small_step * (other - vertex);
  (along_u < along_v ? uv.x : uv.y) = along_u < along_v ? other.x : other.y;
  const surface::SurfacePoint near = surface::evaluate(surface, uv);
  const Vec3 normal = cross(near.xu, near.xv);
  return norm(normal) > 0 ? std::optional(normalized(normal)) : std::nullopt;
}

}  // namespace

std::vector<Vec3> surface_tips(const Chart& chart) {
  struct Vertex {
    Vec3 position, normal;  // the first normal
    bool is_tip = false;
  };
  std::map<int, Vertex> vertices;
  for (int elem = 0; elem < chart.num_elems(); ++elem)
    for (int k = 0; k < 3; ++k)
      for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
        const int first = elem * chart.nodes_per_elem();
        const auto normal =
            normal_beside(chart.surfaces[chart.elem_surface[elem]], chart.uv[first + k], chart.uv[first + other]);
        if (!normal) continue;
        const Vertex seen{chart.space_nodes[first + k], *normal, false};
        Vertex& vertex = vertices.try_emplace(chart.elem2vertices[elem][k], seen).first->second;
        vertex.is_tip |= norm(cross(vertex.normal, *normal)) > std::sin(least_turn);
      }
  std::vector<Vec3> tips;
  for (const auto& [id, vertex] : vertices)
    if (vertex.is_tip) tips.push_back(vertex.position);
  return tips;
}

}  // namespace quadrille::refine
