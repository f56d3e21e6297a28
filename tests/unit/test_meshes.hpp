#pragma once
// Small triangle meshes made by hand, with their CAD faces, for tests of the solver.

#include <array>
#include <cmath>
#include <vector>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille {

/// The polygon's sides as curves; all joints are corners.
inline CadFace polygon_face(const std::vector<Vec2>& corners, double diameter) {
  CadFace face;
  face.diameter = diameter;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = corners[(i + n - 1) % n], b = corners[i], c = corners[(i + 1) % n];
    face.curves.push_back(curve::segment(b, c));
    const double in = angle_of(b - a), out = angle_of(c - b);
    face.joints.push_back({b, in, out, pi - wrap_pi(out - in), true});
  }
  face.loop_offsets = {0, static_cast<int>(n)};
  return face;
}

/// The parallelogram p + a s + b t, s, t in [0, 1], cut into n x n cells of two triangles, diagonals alternating.
inline TriMesh parallelogram_mesh(Vec2 p, Vec2 a, Vec2 b, int n) {
  TriMesh mesh;
  mesh.face = polygon_face({p, p + a, p + a + b, p + b}, std::max(norm(a + b), norm(a - b)));
  const auto vertex = [n](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) mesh.vertices.push_back(p + a * (1.0 * i / n) + b * (1.0 * j / n));
  }
  // Elements below and above the diagonal of cell (i, j), found again for the boundary edges.
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int v0 = vertex(i, j), v1 = vertex(i + 1, j), v2 = vertex(i + 1, j + 1), v3 = vertex(i, j + 1);
      if ((i + j) % 2 == 0) {
        mesh.elem2vertices.push_back({v0, v1, v2});
        mesh.elem2vertices.push_back({v2, v3, v0});
      } else {
        mesh.elem2vertices.push_back({v1, v2, v3});
        mesh.elem2vertices.push_back({v3, v0, v1});
      }
    }
  }
  const auto add_boundary = [&](int from, int to, int curve, int step) {
    for (int e = 0; e < mesh.num_elems(); ++e) {
      for (int k = 0; k < 3; ++k) {
        if (mesh.elem2vertices[e][k] != from || mesh.elem2vertices[e][(k + 1) % 3] != to) continue;
        const double length = mesh.face.curves[curve].end();
        mesh.boundary_edges.push_back({e, k, curve, length * step / n, length * (step + 1) / n});
      }
    }
  };
  for (int i = 0; i < n; ++i) add_boundary(vertex(i, 0), vertex(i + 1, 0), 0, i);
  for (int i = 0; i < n; ++i) add_boundary(vertex(n, i), vertex(n, i + 1), 1, i);
  for (int i = 0; i < n; ++i) add_boundary(vertex(n - i, n), vertex(n - i - 1, n), 2, i);
  for (int i = 0; i < n; ++i) add_boundary(vertex(0, n - i), vertex(0, n - i - 1), 3, i);
  mesh.elem_layer.assign(mesh.num_elems(), -1);
  return mesh;
}

/// The unit disc: `sectors` triangles about its centre, all with one curved edge. One closed boundary curve, a joint
/// without corner at angle 0.
inline TriMesh disc_mesh(int sectors, int order) {
  TriMesh mesh;
  mesh.order = order;
  mesh.face.diameter = 2;
  mesh.face.curves = {curve::circular_arc({0, 0}, 1, 0, 2 * pi)};
  mesh.face.joints = {{{1, 0}, half_pi, half_pi, pi, false}};
  mesh.face.loop_offsets = {0, 1};
  const curve::ArcLength angle(mesh.face.curves[0]);  // on the unit circle: the parameter itself is not the angle
  mesh.vertices.push_back({0, 0});
  for (int i = 0; i < sectors; ++i) mesh.vertices.push_back(unit(2 * pi * i / sectors));
  for (int i = 0; i < sectors; ++i) {
    const int next = (i + 1) % sectors;
    mesh.elem2vertices.push_back({0, 1 + i, 1 + next});
    mesh.boundary_edges.push_back(
        {i, 1, 0, angle.parameter(2 * pi * i / sectors), angle.parameter(2 * pi * (i + 1) / sectors)});
    mesh.curved_elems.push_back(i);
    const Vec2 a = mesh.vertices[1 + i], b = mesh.vertices[1 + next];
    for (const Vec2 xi : spectral::tri_nodes(order)) {
      const double l1 = (1 + xi.x) / 2, l2 = (1 + xi.y) / 2, f = (1 + l2 - l1) / 2;
      const Vec2 on_arc = unit(2 * pi * (i + f) / sectors);
      const Vec2 bulge = (on_arc - a * (1 - f) - b * f) / (f * (1 - f));
      mesh.curved_nodes.push_back(a * l1 + b * l2 + (l1 * l2 > 1e-14 ? l1 * l2 * bulge : Vec2{}));
    }
  }
  mesh.elem_layer.assign(mesh.num_elems(), -1);
  return mesh;
}

}  // namespace quadrille
