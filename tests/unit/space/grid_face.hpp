#pragma once
// A rectangle of the parameters of a surface as a face, in triangles of a grid.

#include <array>
#include <string>
#include <vector>

#include "../curved_surfaces.hpp"
#include "space/raw_space_face.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::space {

/// A straight line through its ends, with a vertex at each of `vertices`.
inline void add_edge(RawSpaceFace& raw, const std::vector<int>& vertices, const SpaceCurve& curve) {
  EdgePolygon polygon{static_cast<int>(raw.curves.size()), vertices, {}};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    polygon.parameters.push_back(curve.begin() + (curve.end() - curve.begin()) * static_cast<double>(i) /
                                                     static_cast<double>(vertices.size() - 1));
  heal::RawEdge label;
  label.cad_edge = polygon.edge;
  raw.labels.wires.resize(1);
  raw.labels.wires.front().push_back(label);
  raw.curves.push_back(curve);
  raw.polygons.push_back(polygon);
}

/// `n` x `n` squares of the parameters [0, 1]^2 of a flat or curved surface, in two triangles each. Edges: bottom,
/// right, top, left, in the direction of rising parameters; lines between the corners of the surface.
inline RawSpaceFace grid_face(const NurbsSurface& surface, int n) {
  RawSpaceFace raw;
  raw.labels.file = "a.step";
  raw.surface = surface;
  const auto uv = [n](int i, int j) { return Vec2{static_cast<double>(i) / n, static_cast<double>(j) / n}; };
  const auto vertex = [n](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) raw.vertices.push_back(surface::point(surface, uv(i, j)));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      raw.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      raw.triangle_uv.push_back({uv(i, j), uv(i + 1, j), uv(i + 1, j + 1)});
      raw.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      raw.triangle_uv.push_back({uv(i, j), uv(i + 1, j + 1), uv(i, j + 1)});
    }
  std::array<std::vector<int>, 4> sides;
  for (int i = 0; i <= n; ++i) {
    sides[0].push_back(vertex(i, 0)), sides[1].push_back(vertex(n, i));
    sides[2].push_back(vertex(i, n)), sides[3].push_back(vertex(0, i));
  }
  for (const std::vector<int>& side : sides)
    add_edge(raw, side, tests::line(raw.vertices[side.front()], raw.vertices[side.back()]));
  return raw;
}

/// The square [0, 2]^2 in z = 0, with parameters [0, 1]^2.
inline NurbsSurface flat_square() {
  return {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {2, 2, 0}}, {1, 1, 1, 1}, false, false};
}

/// A roof with a ridge of `angle` radians at u = 1/2.
inline NurbsSurface roof(double angle) {
  const double z = std::tan(angle / 2);
  return {1,
          1,
          {0, 0, 0.5, 1, 1},
          {0, 0, 1, 1},
          {{0, 0, 0}, {0, 2, 0}, {1, 0, z}, {1, 2, z}, {2, 0, 0}, {2, 2, 0}},
          {1, 1, 1, 1, 1, 1},
          false,
          false};
}

}  // namespace quadrille::space
