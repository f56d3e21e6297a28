#include "export/split_hexes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "export/hex_numbering.hpp"
#include "export/renode.hpp"
#include "spectral/hex_map.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

/// The number of the piece (a, b, c) of an element.
int piece_number(const HexMesh& mesh, int elem, const std::array<int, 3>& at) {
  const int n = mesh.order, quad = elem % mesh.num_quads, layer = elem / mesh.num_quads;
  return ((layer * n + at[2]) * mesh.num_quads + quad) * n * n + at[1] * n + at[0];
}

/// The pieces along a face.
std::vector<std::array<int, 3>> pieces_at_face(int order, int face) {
  std::array<int, 3> sum{};
  for (const int corner : hex_face_corners[face])
    for (int d = 0; d < 3; ++d) sum[d] += hex_corner_indices[corner][d];
  std::vector<std::array<int, 3>> pieces;
  std::array<int, 3> low{}, high{order, order, order};
  for (int d = 0; d < 3; ++d) {
    if (sum[d] == 0) high[d] = 1;
    if (sum[d] == 4) low[d] = order - 1;
  }
  for (int c = low[2]; c < high[2]; ++c)
    for (int b = low[1]; b < high[1]; ++b)
      for (int a = low[0]; a < high[0]; ++a) pieces.push_back({a, b, c});
  return pieces;
}

HexFaceGroup split_group(const HexMesh& mesh, const HexFaceGroup& group) {
  HexFaceGroup split = group;
  split.elems.clear(), split.faces.clear();
  for (std::size_t k = 0; k < group.elems.size(); ++k)
    for (const std::array<int, 3>& at : pieces_at_face(mesh.order, group.faces[k])) {
      split.elems.push_back(piece_number(mesh, group.elems[k], at));
      split.faces.push_back(group.faces[k]);
    }
  return split;
}

void append_pieces(const HexMesh& mesh, int elem, std::vector<int>& elem_nodes) {
  const int n = mesh.order, width = n + 1;
  const std::size_t first = static_cast<std::size_t>(elem) * mesh.nodes_per_elem();
  for (int c = 0; c < n; ++c)
    for (int b = 0; b < n; ++b)
      for (int a = 0; a < n; ++a) {
        int* piece = &elem_nodes[8 * static_cast<std::size_t>(piece_number(mesh, elem, {a, b, c}))];
        for (int local = 0; local < 8; ++local)
          *piece++ = mesh.elem_nodes[first + ((c + local / 4) * width + b + local / 2 % 2) * width + a + local % 2];
      }
}

/// The mean of four edges in one direction, its length, and how far the edges are from it at most.
struct EdgeBundle {
  Vec3 mean;
  double length = 0, spread = 0;
};

EdgeBundle bundle(const std::array<Vec3, 8>& nodes, int stride) {
  std::array<Vec3, 4> edges;
  std::size_t count = 0;
  for (int k = 0; k < 8; ++k)
    if ((k & stride) == 0) edges[count++] = nodes[k + stride] - nodes[k];
  EdgeBundle all{0.25 * (edges[0] + edges[1] + edges[2] + edges[3])};
  all.length = norm(all.mean);
  for (const Vec3 edge : edges) all.spread = std::max(all.spread, distance(edge, all.mean));
  return all;
}

/// A lower bound of det J of a hexahedron of order 1, a tenth of the work of hex_bounds. Twice each derivative is a
/// mean of four edges, so within their spread s of their mean u, and
///   8 det J >= det(u1, u2, u3) - ((|u1| + s1) (|u2| + s2) (|u3| + s3) - |u1| |u2| |u3|).
/// Not above 0 if that is within the rounding.
double bound_by_edges(const std::array<Vec3, 8>& nodes) {
  const EdgeBundle u = bundle(nodes, 1), v = bundle(nodes, 2), w = bundle(nodes, 4);
  const double most = (u.length + u.spread) * (v.length + v.spread) * (w.length + w.spread);
  const double bound = dot(cross(u.mean, v.mean), w.mean) - (most - u.length * v.length * w.length);
  return bound > 1e-9 * most ? bound / 8 : 0;
}

void judge_pieces(HexMesh& pieces) {
  const std::size_t count = pieces.elem_nodes.size() / 8;
  for (std::size_t elem = 0; elem < count; ++elem) {
    std::array<Vec3, 8> nodes;
    for (int k = 0; k < 8; ++k) nodes[k] = pieces.nodes[pieces.elem_nodes[8 * elem + k]];
    const double bound = bound_by_edges(nodes);
    pieces.elem_jacobian_bound.push_back(bound > 0 ? bound : spectral::hex_bounds(1, nodes.data()).jacobian);
  }
  pieces.least_jacobian_bound = *std::min_element(pieces.elem_jacobian_bound.begin(), pieces.elem_jacobian_bound.end());
  pieces.is_valid = pieces.least_jacobian_bound > 0;
}

constexpr int parts = 4;  ///< of a small face in each direction, for boundary_move

/// The same for one face, whose nodes run along its first direction first. `basis`: its polynomials at the ends of all
/// parts.
double face_move(const HexMesh& mesh, const std::vector<int>& nodes, const Eigen::MatrixXd& basis) {
  const int n = mesh.order, width = n + 1;
  const auto node = [&](int a, int b) { return mesh.nodes[nodes[b * width + a]]; };
  double largest = 0;
  for (int row = 0; row < basis.rows(); ++row)
    for (int column = 0; column < basis.rows(); ++column) {
      Vec3 off{};
      for (int b = 0; b <= n; ++b)
        for (int a = 0; a <= n; ++a) off += basis(column, a) * basis(row, b) * node(a, b);
      const int a = std::min(column / parts, n - 1), b = std::min(row / parts, n - 1);
      const double s = static_cast<double>(column) / parts - a, t = static_cast<double>(row) / parts - b;
      const Vec3 below = node(a + 1, b) - node(a, b), above = node(a + 1, b + 1) - node(a, b + 1),
                 left = node(a, b + 1) - node(a, b), right = node(a + 1, b + 1) - node(a + 1, b);
      off -= node(a, b) + s * below + t * (left + s * (right - left));
      const Vec3 normal = cross(below + t * (above - below), left + s * (right - left));
      largest = std::max(largest, std::abs(dot(off, normalized(normal))));
    }
  return largest;
}

}  // namespace

HexMesh split_at_nodes(const HexMesh& mesh) {
  HexMesh pieces = mesh;
  const int n = mesh.order;
  pieces.order = 1;
  pieces.num_quads = mesh.num_quads * n * n;
  pieces.elem_nodes.resize(8 * static_cast<std::size_t>(mesh.num_elems()) * n * n * n);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) append_pieces(mesh, elem, pieces.elem_nodes);
  pieces.quad_block.clear();
  for (const int block : mesh.quad_block) pieces.quad_block.insert(pieces.quad_block.end(), n * n, block);
  for (HexFaceGroup& group : pieces.face_groups) group = split_group(mesh, group);
  pieces.elem_jacobian_bound.clear(), pieces.elem_scaled_jacobian.clear();
  judge_pieces(pieces);
  return pieces;
}

void require_valid_pieces(const HexMesh& pieces, const std::string& reader) {
  for (int elem = 0; elem < pieces.num_elems(); ++elem) {
    if (pieces.elem_jacobian_bound[elem] > 0) continue;
    Vec3 middle{};
    for (int k = 0; k < 8; ++k)
      middle += 0.125 * pieces.nodes[pieces.elem_nodes[8 * static_cast<std::size_t>(elem) + k]];
    throw ComputeError(fmt::format("{} have straight edges, and one near {} would be folded; refine the mesh", reader,
                                   position_text(middle)));
  }
}

std::string split_loss(const HexMesh& mesh) {
  const std::vector<double>& gll = spectral::gll_points(mesh.order);
  std::vector<double> ends;
  for (int k = 0; k < mesh.order; ++k)
    for (int part = 0; part < parts; ++part) ends.push_back(gll[k] + part * (gll[k + 1] - gll[k]) / parts);
  ends.push_back(1);
  const Eigen::MatrixXd basis = spectral::interpolation_matrix(gll, ends);
  double moved = 0;
  for (const HexFaceGroup& group : mesh.face_groups)
    for (std::size_t k = 0; k < group.elems.size() && !group.is_interface; ++k)
      moved = std::max(moved, face_move(mesh, face_nodes(mesh, group.elems[k], group.faces[k]), basis));
  if (moved <= 1e-12 * mesh.diameter) return {};
  return fmt::format("elements have straight edges, which moves the boundary by up to {}",
                     length_text(moved, mesh.diameter));
}

}  // namespace quadrille::exports
