#include "refine/relax_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/transfinite.hpp"
#include "model/quad_mesh.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

constexpr int power = 4;

double power_of(double mu) { return mu * mu * mu * mu; }
static_assert(power == 4);

}  // namespace

ShapeEnergy::ShapeEnergy(const QuadMesh& mesh)
    : order_(mesh.order),
      elem_nodes_(mesh.elem_nodes),
      derivative_(spectral::differentiation_matrix(spectral::gll_points(mesh.order))) {
  inverse_lengths_.reserve(mesh.elem_nodes.size());
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    const Jacobians j = jacobians(elem, mesh.nodes);
    for (Eigen::Index k = 0; k < j.x1.size(); ++k)
      inverse_lengths_.push_back(
          {1 / std::hypot(j.x1.data()[k], j.y1.data()[k]), 1 / std::hypot(j.x2.data()[k], j.y2.data()[k])});
  }
}

ShapeEnergy::Jacobians ShapeEnergy::jacobians(int elem, const std::vector<Vec2>& nodes) const {
  const int width = order_ + 1, count = width * width;
  Eigen::MatrixXd x(width, width), y(width, width);
  const Vec2 start = nodes[elem_nodes_[elem * count]];
  for (int k = 0; k < count; ++k) {
    const Vec2 node = nodes[elem_nodes_[elem * count + k]] - start;
    x.data()[k] = node.x;
    y.data()[k] = node.y;
  }
  return {derivative_ * x, x * derivative_.transpose(), derivative_ * y, y * derivative_.transpose()};
}

double ShapeEnergy::value(int elem, const std::vector<Vec2>& nodes) const {
  const Jacobians j = jacobians(elem, nodes);
  const Eigen::Index count = j.x1.size();
  double sum = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Vec2 scale = inverse_lengths_[elem * count + k];
    const Vec2 a = scale.x * Vec2{j.x1.data()[k], j.y1.data()[k]}, b = scale.y * Vec2{j.x2.data()[k], j.y2.data()[k]};
    const double det = cross(a, b);
    if (!(det > 0)) return std::numeric_limits<double>::infinity();
    sum += power_of((norm2(a) + norm2(b)) / (2 * det));
  }
  return sum / static_cast<double>(count);
}

ElementEnergy ShapeEnergy::with_derivatives(int elem, const std::vector<Vec2>& nodes) const {
  const Jacobians j = jacobians(elem, nodes);
  const int width = order_ + 1, count = width * width;
  const std::vector<double>& xi = spectral::gll_points(order_);
  const std::array<Vec2, 4> corners{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}};
  ElementEnergy energy;
  for (int k = 0; k < count; ++k) {
    const Vec2 scale = inverse_lengths_[elem * count + k];
    const Vec2 a = scale.x * Vec2{j.x1.data()[k], j.y1.data()[k]}, b = scale.y * Vec2{j.x2.data()[k], j.y2.data()[k]};
    const double det = cross(a, b), mu = (norm2(a) + norm2(b)) / (2 * det);
    const double weight = 1.0 / count, slope = weight * power * mu * mu * mu, bend = weight * 12 * mu * mu;
    energy.value += weight * power_of(mu);
    const Vec2 by_a = (a - mu * Vec2{b.y, -b.x}) / det, by_b = (b - mu * Vec2{-a.y, a.x}) / det;
    for (int c = 0; c < 4; ++c) {
      const double d1 = scale.x * corners[c].x * (1 + corners[c].y * xi[k / width]) / 4;
      const double d2 = scale.y * corners[c].y * (1 + corners[c].x * xi[k % width]) / 4;
      const Vec2 g = d1 * by_a + d2 * by_b;
      const double round = slope * (d1 * d1 + d2 * d2) / det;
      energy.gradient[c] += slope * g;
      energy.hessian[c][0] += round + bend * g.x * g.x;
      energy.hessian[c][1] += bend * g.x * g.y;
      energy.hessian[c][2] += round + bend * g.y * g.y;
    }
  }
  return energy;
}

NodeFollow::NodeFollow(const QuadMesh& mesh, const BoundarySlide& boundary)
    : mesh_(&mesh), boundary_(&boundary), nodes_(mesh.nodes) {
  std::vector<int> node2vertex(mesh.nodes.size(), -1);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    std::array<int, 4> vertices{};
    for (int c = 0; c < 4; ++c) {
      const int node = side_start(mesh, elem, c);
      if (node2vertex[node] < 0) {
        node2vertex[node] = num_vertices();
        vertex_nodes_.push_back(node);
      }
      vertices[c] = node2vertex[node];
    }
    elem_vertices_.push_back(vertices);
  }
  on_boundary_.assign(vertex_nodes_.size(), -1);
  for (std::size_t b = 0; b < boundary.vertices().size(); ++b) {
    boundary2vertex_.push_back(node2vertex[boundary.vertices()[b].node]);
    on_boundary_[boundary2vertex_.back()] = static_cast<int>(b);
  }
}

int NodeFollow::node_of(int elem, int i, int j) const {
  return mesh_->elem_nodes[elem * mesh_->nodes_per_elem() + j * (mesh_->order + 1) + i];
}

std::vector<Vec2> NodeFollow::nodes(const VertexMoves& moves) const {
  std::vector<Vec2> shifts(nodes_.size());
  shift_sides(moves, shifts);
  for (int elem = 0; elem < mesh_->num_elems(); ++elem) shift_inside(elem, shifts);
  std::vector<Vec2> nodes = nodes_;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (shifts[i] != Vec2{}) nodes[i] += shifts[i];
  // Sums have rounding errors; the boundary's nodes must lie on their curves.
  for_moved_edges(moves, [&](const SlidingEdge& edge, double from, double to, const std::vector<Vec2>& on_curve) {
    for (int k = 0; k <= mesh_->order; ++k)
      if ((k > 0 || from != 0) && (k < mesh_->order || to != 0)) nodes[edge_node(edge, k)] = on_curve[k];
  });
  return nodes;
}

int NodeFollow::edge_node(const SlidingEdge& edge, int k) const { return side_node(*mesh_, edge.elem, edge.side, k); }

template <class Visit>
void NodeFollow::for_moved_edges(const VertexMoves& moves, const Visit& visit) const {
  for (std::size_t e = 0; e < boundary_->edges().size(); ++e) {
    const SlidingEdge& edge = boundary_->edges()[e];
    const double from = slide(edge.from, moves), to = slide(edge.to, moves);
    if (from != 0 || to != 0) visit(edge, from, to, boundary_->edge_nodes(static_cast<int>(e), from, to));
  }
}

void NodeFollow::shift_sides(const VertexMoves& moves, std::vector<Vec2>& shifts) const {
  for (int v = 0; v < num_vertices(); ++v) {
    const int b = on_boundary_[v];
    if (moves[v] == Vec2{}) continue;
    shifts[vertex_nodes_[v]] = b < 0 ? moves[v] : boundary_->at(b, moves[v].x).position - nodes_[vertex_nodes_[v]];
  }
  const std::vector<double>& xi = spectral::gll_points(mesh_->order);
  for (int elem = 0; elem < mesh_->num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> nodes = side_nodes(*mesh_, elem, side);
      const Vec2 from = shifts[nodes.front()], to = shifts[nodes.back()];
      for (int k = 1; k < mesh_->order; ++k) shifts[nodes[k]] = (1 - xi[k]) / 2 * from + (1 + xi[k]) / 2 * to;
    }
  for_moved_edges(moves, [&](const SlidingEdge& edge, double, double, const std::vector<Vec2>& on_curve) {
    for (int k = 1; k < mesh_->order; ++k) shifts[edge_node(edge, k)] = on_curve[k] - nodes_[edge_node(edge, k)];
  });
}

/// Gordon-Hall blend of the shifts on the sides.
void NodeFollow::shift_inside(int elem, std::vector<Vec2>& shifts) const {
  const int n = mesh_->order;
  const std::vector<double>& xi = spectral::gll_points(n);
  const auto at = [&](int i, int j) { return shifts[node_of(elem, i, j)]; };
  const std::array<Vec2, 4> corner{at(0, 0), at(n, 0), at(n, n), at(0, n)};
  if (std::ranges::count(corner, Vec2{}) == 4) return;
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      shifts[node_of(elem, i, j)] =
          mesh::blend_sides({at(i, 0), at(n, j), at(i, n), at(0, j)}, corner, (1 + xi[i]) / 2, (1 + xi[j]) / 2);
    }
}

RelaxProblem::RelaxProblem(const QuadMesh& mesh, const std::vector<bool>& frozen_elems, SlidesOff slides_off)
    : start(mesh),
      boundary(start, slides_off),
      follow(start, boundary),
      energy(start),
      is_fixed(follow.num_vertices(), false),
      twin_(follow.num_vertices(), -1) {
  for (const auto& [a, b] : boundary.twins()) {
    twin_[follow.vertex_of(a)] = follow.vertex_of(b);
    twin_[follow.vertex_of(b)] = follow.vertex_of(a);
  }
  std::vector<int> num_loops(num_vertices(), 0);
  for (std::size_t b = 0; b < boundary.vertices().size(); ++b) {
    const int v = follow.vertex_of(static_cast<int>(b));
    if (boundary.vertices()[b].is_fixed || ++num_loops[v] > 2) fix_vertex(v);
  }
  for (std::size_t elem = 0; elem < frozen_elems.size(); ++elem)
    if (frozen_elems[elem])
      for (const int v : follow.elem_vertices()[elem]) fix_vertex(v);
}

void RelaxProblem::fix_vertex(int vertex) {
  is_fixed[vertex] = true;
  if (twin_[vertex] >= 0) is_fixed[twin_[vertex]] = true;
}

void RelaxProblem::join_twins(VertexMoves& moves) const {
  for (int v = 0; v < num_vertices(); ++v) {
    if (twin_[v] <= v) continue;
    const double slide = (moves[v].x - moves[twin_[v]].x) / 2;
    moves[v].x = slide, moves[twin_[v]].x = -slide;
  }
}

double RelaxProblem::total_energy(const std::vector<Vec2>& nodes) const {
  double sum = 0;
  for (int elem = 0; elem < start.num_elems(); ++elem) sum += energy.value(elem, nodes);
  return sum;
}

}  // namespace quadrille::refine
