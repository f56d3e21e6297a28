#pragma once
// A hand-made field on a square: triangles in a regular pattern, coefficients from any function of the plane.

#include <functional>
#include <vector>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "mesh/tri_topology.hpp"
#include "model/field.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille {

/// The square [low, low + size] x [...] as a CAD face of four segments, counter-clockwise from `low`.
inline CadFace square_face(Vec2 low, double size) {
  const std::array<Vec2, 4> p{low, low + Vec2{size, 0}, low + Vec2{size, size}, low + Vec2{0, size}};
  CadFace face;
  face.diameter = size * std::sqrt(2.0);
  face.loop_offsets = {0, 4};
  for (int i = 0; i < 4; ++i) {
    face.curves.push_back(curve::segment(p[i], p[(i + 1) % 4]));
    face.curve_names.push_back("side" + std::to_string(i));
    face.curve_cad_edges.push_back(i);
    face.joints.push_back({p[i], angle_of(p[i] - p[(i + 3) % 4]), angle_of(p[(i + 1) % 4] - p[i]), half_pi, true});
  }
  return face;
}

/// n x n squares, each cut from lower left to upper right.
inline TriMesh square_mesh(Vec2 low, double size, int n) {
  TriMesh mesh;
  mesh.face = square_face(low, size);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) mesh.vertices.push_back(low + Vec2{size * i / n, size * j / n});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, d = a + n + 1;
      mesh.elem2vertices.push_back({a, a + 1, d + 1});
      mesh.elem2vertices.push_back({a, d + 1, d});
    }
  for (int side = 0; side < 4; ++side) {
    const Nurbs& curve = mesh.face.curves[side];
    const double step = (curve.end() - curve.begin()) / n;
    for (int s = 0; s < n; ++s) {
      const int lower = 2 * s, right = 2 * (s * n + n - 1), upper = 2 * ((n - 1) * n + n - 1 - s) + 1,
                left = 2 * ((n - 1 - s) * n) + 1;
      const std::array<int, 4> elem{lower, right, upper, left};
      const std::array<int, 4> edge{0, 1, 1, 2};
      mesh.boundary_edges.push_back(
          {elem[side], edge[side], side, curve.begin() + s * step, curve.begin() + (s + 1) * step});
    }
  }
  mesh.elem_layer.assign(mesh.elem2vertices.size(), -1);
  return mesh;
}

/// The interpolant of degree `order` on every element: exact for polynomials on affine elements.
inline Field interpolated_field(TriMesh mesh, int order, const std::function<Vec2(Vec2)>& value) {
  Field field;
  field.mesh = std::move(mesh);
  const int n = spectral::num_tri_modes(order);
  const Eigen::MatrixXd to_modes = spectral::orthogonal_vandermonde(order, spectral::tri_nodes(order)).inverse();
  field.coef_offsets = {0};
  for (const spectral::TriMap& map : mesh::tri_maps(field.mesh)) {
    Eigen::MatrixX2d values(n, 2);
    for (int i = 0; i < n; ++i) {
      const Vec2 v = value(map.position(spectral::tri_nodes(order)[i]));
      values.row(i) << v.x, v.y;
    }
    const Eigen::MatrixX2d coefs = to_modes * values;
    field.u.insert(field.u.end(), coefs.col(0).begin(), coefs.col(0).end());
    field.v.insert(field.v.end(), coefs.col(1).begin(), coefs.col(1).end());
    field.elem_order.push_back(order);
    field.coef_offsets.push_back(static_cast<int>(field.u.size()));
  }
  return field;
}

}  // namespace quadrille
