#include "export/split_elements.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "export/edge_numbering.hpp"
#include "export/renode.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quad_map.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

/// The reference coordinates of all nodes of the pieces in one direction.
std::vector<double> piece_points(const std::vector<double>& breaks, int order) {
  std::vector<double> points;
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    if (k > 0 && order == 2) points.push_back((breaks[k - 1] + breaks[k]) / 2);
    points.push_back(breaks[k]);
  }
  return points;
}

/// The numbers of all nodes of the pieces: a grid of (G + 1)^2 for each element, xi1 fastest.
class NodeGrids {
 public:
  NodeGrids(const QuadMesh& mesh, int grid_order)
      : mesh_(mesh), grid_order_(grid_order), edges_(number_parts(mesh)), inner_(grid_order - 1) {}

  const EdgeNumbering& edges() const { return edges_; }
  int count() const { return first_inside() + mesh_.num_elems() * inner_ * inner_; }
  int edge_node(int edge, int k) const { return edges_.num_vertices() + edge * inner_ + k - 1; }
  int inside_node(int elem, int i, int j) const { return first_inside() + (elem * inner_ + j - 1) * inner_ + i - 1; }

  /// The grid of an element.
  std::vector<int> grid(int elem) const {
    const int width = grid_order_ + 1;
    std::vector<int> ids(width * width);
    for (int side = 0; side < 4; ++side)
      for (int k = 0; k < grid_order_; ++k)
        ids[local_side_node(grid_order_, side, k)] = side_node_number(elem, side, k);
    for (int j = 1; j < grid_order_; ++j)
      for (int i = 1; i < grid_order_; ++i) ids[j * width + i] = inside_node(elem, i, j);
    return ids;
  }

 private:
  int first_inside() const { return edges_.num_vertices() + edges_.num_edges() * inner_; }

  int side_node_number(int elem, int side, int k) const {
    const int vertex = edges_.elem2verts[4 * elem + side];
    if (k == 0) return vertex;
    const int edge = edges_.elem2edges[4 * elem + side];
    return edge_node(edge, edges_.edges[edge].vertices[0] == vertex ? k : grid_order_ - k);
  }

  const QuadMesh& mesh_;
  int grid_order_;
  EdgeNumbering edges_;
  int inner_;
};

template <typename Point>
std::vector<Point> grid_nodes(const QuadMesh& mesh, const NodeGrids& grids, const Eigen::MatrixXd& basis,
                              const std::vector<Point>& nodes) {
  std::vector<Point> points(grids.count());
  const int n = mesh.order, width = n + 1, last = static_cast<int>(basis.rows()) - 1;
  for (int v = 0; v < grids.edges().num_vertices(); ++v) points[v] = nodes[grids.edges().vertices[v]];
  for (int e = 0; e < grids.edges().num_edges(); ++e) {
    const std::vector<int> of_edge = edge_nodes(mesh, grids.edges().edges[e]);
    for (int k = 1; k < last; ++k)
      for (int a = 0; a <= n; ++a) points[grids.edge_node(e, k)] += basis(k, a) * nodes[of_edge[a]];
  }
  std::vector<Point> half(width);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const int* ids = &mesh.elem_nodes[elem * mesh.nodes_per_elem()];
    for (int i = 1; i < last; ++i) {
      for (int b = 0; b <= n; ++b) {
        half[b] = {};
        for (int a = 0; a <= n; ++a) half[b] += basis(i, a) * nodes[ids[b * width + a]];
      }
      for (int j = 1; j < last; ++j)
        for (int b = 0; b <= n; ++b) points[grids.inside_node(elem, i, j)] += basis(j, b) * half[b];
    }
  }
  return points;
}

/// The pieces along sides of elements, each with its curve, in the order of the edges.
std::vector<QuadBoundaryEdge> piece_edges(const std::vector<QuadBoundaryEdge>& edges, int m) {
  std::vector<QuadBoundaryEdge> pieces;
  for (const QuadBoundaryEdge& e : edges)
    for (int k = 0; k < m; ++k) {
      const std::array<int, 4> is{k, m - 1, m - 1 - k, 0}, js{0, k, m - 1, m - 1 - k};
      pieces.push_back({(e.elem * m + js[e.side]) * m + is[e.side], e.side, e.curve});
    }
  return pieces;
}

void append_pieces(const std::vector<int>& grid, int m, int order, std::vector<int>& elem_nodes) {
  const int width = m * order + 1;
  for (int b = 0; b < m; ++b)
    for (int a = 0; a < m; ++a)
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i) elem_nodes.push_back(grid[(b * order + j) * width + a * order + i]);
}

/// All but the elements.
QuadMesh without_elements(const QuadMesh& mesh) {
  QuadMesh result;
  result.provenance = mesh.provenance, result.face = mesh.face;
  result.open_curves = mesh.open_curves;
  result.block_names = mesh.block_names, result.unnamed_blocks = mesh.unnamed_blocks;
  result.block_region = mesh.block_region;
  result.num_irregular = mesh.num_irregular;
  result.is_valid = mesh.is_valid;
  return result;
}

template <typename Point>
std::vector<Point> nodes_of(const QuadMesh& mesh, const std::vector<Point>& nodes, int elem) {
  std::vector<Point> own;
  for (int k = 0; k < mesh.nodes_per_elem(); ++k)
    own.push_back(nodes[mesh.elem_nodes[elem * mesh.nodes_per_elem() + k]]);
  return own;
}

/// The largest component of the distance between the points of `mesh` and of its pieces along the boundary that is
/// normal to the latter, on seven points between the ends of each piece.
template <typename Point>
double boundary_move(const QuadMesh& mesh, const std::vector<Point>& nodes, const QuadMesh& pieces,
                     const std::vector<Point>& piece_nodes, const std::vector<double>& breaks) {
  constexpr int parts = 8;
  const std::vector<double>& gll = spectral::gll_points(mesh.order);
  const int m = static_cast<int>(breaks.size()) - 1;
  std::vector<double> whole_at, piece_at;
  for (int k = 1; k < parts; ++k) piece_at.push_back(-1 + 2.0 * k / parts);
  for (int piece = 0; piece < m; ++piece)
    for (const double t : piece_at)
      whole_at.push_back(breaks[piece] + (1 + t) / 2 * (breaks[piece + 1] - breaks[piece]));
  const std::vector<double>& piece_gll = spectral::gll_points(pieces.order);
  const Eigen::MatrixXd of_whole = spectral::interpolation_matrix(gll, whole_at),
                        of_piece = spectral::interpolation_matrix(piece_gll, piece_at),
                        slope = of_piece * spectral::differentiation_matrix(piece_gll);
  double largest = 0;
  for (std::size_t e = 0; e < mesh.boundary_edges.size(); ++e) {
    const std::vector<int> whole = side_nodes(mesh, mesh.boundary_edges[e].elem, mesh.boundary_edges[e].side);
    for (int row = 0; row < of_whole.rows(); ++row) {
      const QuadBoundaryEdge& edge = pieces.boundary_edges[e * m + row / (parts - 1)];
      const std::vector<int> piece = side_nodes(pieces, edge.elem, edge.side);
      Point off{}, along{};
      for (int k = 0; k <= mesh.order; ++k) off += of_whole(row, k) * nodes[whole[k]];
      for (int k = 0; k <= pieces.order; ++k) {
        off -= of_piece(row % (parts - 1), k) * piece_nodes[piece[k]];
        along += slope(row % (parts - 1), k) * piece_nodes[piece[k]];
      }
      along = normalized(along);
      largest = std::max(largest, norm(off - dot(off, along) * along));
    }
  }
  return largest;
}

/// The intervals that the pieces were made by.
std::vector<double> breaks_of(const QuadMesh& mesh, const QuadMesh& pieces) {
  if (pieces.order == 1) return spectral::gll_points(mesh.order);
  const int m = (mesh.order + 1) / 2;
  std::vector<double> breaks;
  for (int k = 0; k <= m; ++k) breaks.push_back(-1 + 2.0 * k / m);
  return breaks;
}

}  // namespace

QuadMesh split_elements(const QuadMesh& mesh, const std::vector<double>& breaks, int order) {
  const int m = static_cast<int>(breaks.size()) - 1;
  const NodeGrids grids(mesh, m * order);
  const Eigen::MatrixXd basis =
      spectral::interpolation_matrix(spectral::gll_points(mesh.order), piece_points(breaks, order));
  QuadMesh pieces = without_elements(mesh);
  pieces.order = order;
  pieces.nodes = grid_nodes(mesh, grids, basis, mesh.nodes);
  if (!mesh.space_nodes.empty()) pieces.space_nodes = grid_nodes(mesh, grids, basis, mesh.space_nodes);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    append_pieces(grids.grid(elem), m, order, pieces.elem_nodes);
    pieces.elem_block.insert(pieces.elem_block.end(), m * m, mesh.elem_block[elem]);
  }
  pieces.boundary_edges = piece_edges(mesh.boundary_edges, m);
  pieces.interface_edges = piece_edges(mesh.interface_edges, m);
  return pieces;
}

QuadMesh split_at_nodes(const QuadMesh& mesh) { return split_elements(mesh, spectral::gll_points(mesh.order), 1); }

QuadMesh split_to_quadratic(const QuadMesh& mesh) {
  if (mesh.order == 1) return split_at_nodes(mesh);
  QuadMesh shape;  // of the pieces, for breaks_of
  shape.order = 2;
  return split_elements(mesh, breaks_of(mesh, shape), 2);
}

bool is_convex(const std::array<Vec2, 4>& corners) {
  for (int k = 0; k < 4; ++k)
    if (cross(corners[(k + 1) % 4] - corners[k], corners[(k + 3) % 4] - corners[k]) <= 0) return false;
  return true;
}

void require_convex_cells(const QuadMesh& mesh, const std::string& reader) {
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    std::array<Vec2, 4> corners;
    for (int k = 0; k < 4; ++k) corners[k] = mesh.nodes[side_start(mesh, elem, k)];
    if (is_convex(corners)) continue;
    const Vec2 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]) + mesh.face.origin;
    throw ComputeError(fmt::format("{} have straight sides, and one near {} would not be convex; refine the mesh",
                                   reader, position_text(middle)));
  }
}

void require_valid_pieces(const QuadMesh& pieces, const std::string& reader) {
  if (pieces.order == 1 && pieces.space_nodes.empty()) return require_convex_cells(pieces, reader);
  for (int elem = 0; elem < pieces.num_elems(); ++elem) {
    const std::vector<Vec2> nodes = nodes_of(pieces, pieces.nodes, elem);
    const double bound =
        pieces.space_nodes.empty()
            ? spectral::quad_jacobian_lower_bound(pieces.order, nodes.data())
            : spectral::quad_normal_lower_bound(pieces.order, nodes_of(pieces, pieces.space_nodes, elem).data());
    if (bound > 0) continue;
    throw ComputeError(
        fmt::format("{} have order {}, and one near {} would be folded; refine the mesh", reader, pieces.order,
                    position_text(spectral::quad_position(pieces.order, nodes.data(), {0, 0}) + pieces.face.origin)));
  }
}

std::string split_loss(const QuadMesh& mesh, const QuadMesh& pieces) {
  const std::vector<double> breaks = breaks_of(mesh, pieces);
  const double moved = mesh.space_nodes.empty()
                           ? boundary_move(mesh, mesh.nodes, pieces, pieces.nodes, breaks)
                           : boundary_move(mesh, mesh.space_nodes, pieces, pieces.space_nodes, breaks);
  if (moved <= 1e-12 * mesh.face.diameter) return {};
  return fmt::format("elements have {} as sides, which moves the boundary by up to {}",
                     pieces.order == 1 ? "straight lines" : "parabolas", length_text(moved, mesh.face.diameter));
}

}  // namespace quadrille::exports
