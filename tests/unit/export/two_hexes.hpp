#pragma once
// Hexahedral meshes of two quads swept upwards, small enough to know their files.

#include <cmath>
#include <functional>

#include "export/exported.hpp"
#include "model/hex_mesh.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

/// How two_hexes makes its mesh.
struct TwoHexes {
  int order = 1;
  int layers = 1;
  int first_corner = 0;  ///< of the second quad: at which of its corners, counter-clockwise, its coordinates begin
  std::function<Vec3(Vec3)> map = [](Vec3 x) { return x; };
};

/// A map that bends all edges and faces.
inline Vec3 bent(Vec3 x) {
  return {x.x + 0.1 * std::sin(x.y + x.z), x.y + 0.1 * x.x * x.z * (1 - x.z / 4), x.z + 0.1 * std::cos(x.x - x.y)};
}

/// Node (i, j) of a quad whose coordinates begin at a corner, in the grid of the plane.
inline std::array<int, 2> from_corner(int order, int corner, int i, int j) {
  for (int turn = 0; turn < corner; ++turn) {
    const int before = i;
    i = order - j, j = before;
  }
  return {i, j};
}

/// [0, 2]^2 and [2, 4] x [0, 2], each layer of height 1, moved by the map. Groups: "wall" (y = 0, y = 2, x = 0),
/// "outlet" (x = 4), "between" (the interface x = 2), "bottom", "top". Regions "fluid" and "solid".
inline HexMesh two_hexes(const TwoHexes& shape) {
  const int n = shape.order, width = n + 1, columns = 2 * n + 1;
  const auto place = [&](int i) { return i / n + (1 + spectral::gll_points(n)[i % n]) / 2; };
  HexMesh mesh;
  mesh.order = n, mesh.num_quads = 2, mesh.diameter = 5, mesh.length_unit = "millimetre";
  mesh.quad_block = {0, 1}, mesh.block_region = {0, 1}, mesh.region_names = {"fluid", "solid"};
  for (int k = 0; k <= shape.layers * n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i < columns; ++i) mesh.nodes.push_back(shape.map({2 * place(i), 2 * place(j), place(k)}));
  mesh.face_groups.resize(5);
  const char* const names[] = {"wall", "outlet", "between", "bottom", "top"};
  for (int g = 0; g < 5; ++g) mesh.face_groups[g].name = names[g];
  mesh.face_groups[2].is_interface = true;
  const std::array<std::array<int, 4>, 2> side_groups{{{0, 2, 0, 0}, {0, 1, 0, 2}}};
  for (int layer = 0; layer < shape.layers; ++layer)
    for (int quad = 0; quad < 2; ++quad) {
      const int elem = 2 * layer + quad, corner = quad == 1 ? shape.first_corner : 0;
      for (int k = 0; k <= n; ++k)
        for (int j = 0; j <= n; ++j)
          for (int i = 0; i <= n; ++i) {
            const auto [a, b] = from_corner(n, corner, i, j);
            mesh.elem_nodes.push_back(((layer * n + k) * width + b) * columns + quad * n + a);
          }
      const auto add = [&](int group, int face) {
        mesh.face_groups[group].elems.push_back(elem), mesh.face_groups[group].faces.push_back(face);
      };
      for (int side = 0; side < 4; ++side) add(side_groups[quad][side], (side + 4 - corner) % 4);
      if (layer == 0) add(3, 4);
      if (layer == shape.layers - 1) add(4, 5);
      mesh.elem_jacobian_bound.push_back(0.5), mesh.elem_scaled_jacobian.push_back(0.5);
    }
  return mesh;
}

/// Makes "bottom" and "top" images of each other; of a mesh whose map moves z alone by a constant.
inline void join_ends(HexMesh& mesh, double height) {
  mesh.face_groups[3].periodic_with = 4;
  mesh.face_groups[3].motion.shift = {0, 0, height};
}

/// The mesh of the examples of the pages: two straight hexahedra, the second turned.
inline HexMesh two_hexes_of_the_pages() { return two_hexes({.order = 1, .first_corner = 1}); }

}  // namespace quadrille::exports
