#include "refine/inner_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/tolerance.hpp"
#include "refine/validity.hpp"
#include "spectral/quad_map.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

constexpr double good_scaled_jacobian = 0.6;  ///< an element with a greater one need not keep its curves
constexpr double halved = 0.5;                ///< curvature of a ring over that of the ring before, InnerEdges::fade

class EdgeShaper {
 public:
  EdgeShaper(QuadMesh& mesh, InnerEdges shape, const std::vector<bool>& kept);
  void run();

 private:
  struct Edge {
    bool is_inside = true;   ///< on no CAD curve
    bool is_curved = false;  ///< keeps its curve
    double factor = 0;       ///< of its displacement otherwise
    double bend = 0;         ///< greatest displacement over the chord
    std::array<int, 2> elems{-1, -1};
  };

  void number_edges();
  void mark_curves();
  void fade();
  void curve_edge(int edge) { edges_[edge].is_curved = true; }
  Edge& edge(int elem, int side) { return edges_[elem_edges_[elem][side]]; }
  double factor(const Edge& e) const { return !e.is_inside || e.is_curved ? 1 : e.factor; }
  bool is_unchanged(int elem) const;
  Vec2 chord_point(int elem, int side, int k) const;
  double bend_of(int elem, int side) const;
  void place_edges(int elem);
  void place_inside(int elem);
  void restore_inside(int elem);
  bool is_worse(int elem) const;
  std::vector<int> restore_curves(const std::vector<int>& elems);

  QuadMesh& mesh_;
  const QuadMesh before_;
  const std::vector<double>& xi_;
  std::vector<Edge> edges_;
  std::vector<std::array<int, 4>> elem_edges_;
};

EdgeShaper::EdgeShaper(QuadMesh& mesh, InnerEdges shape, const std::vector<bool>& kept)
    : mesh_(mesh), before_(mesh), xi_(spectral::gll_points(mesh.order)) {
  number_edges();
  mark_curves();
  if (shape == InnerEdges::fade) fade();
  for (std::size_t elem = 0; elem < kept.size(); ++elem)
    if (kept[elem])
      for (const int edge : elem_edges_[elem]) curve_edge(edge);
}

/// An edge is known by the lesser of its first and last inner nodes: two edges may have the same ends.
void EdgeShaper::number_edges() {
  std::vector<int> node2edge(mesh_.nodes.size(), -1);
  elem_edges_.resize(mesh_.num_elems());
  for (int elem = 0; elem < mesh_.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      int& number = node2edge[std::min(side_node(mesh_, elem, side, 1), side_node(mesh_, elem, side, mesh_.order - 1))];
      if (number < 0) {
        number = static_cast<int>(edges_.size());
        edges_.push_back({.bend = bend_of(elem, side)});
      }
      elem_edges_[elem][side] = number;
      edges_[number].elems[edges_[number].elems[0] >= 0] = elem;
    }
}

void EdgeShaper::mark_curves() {
  for (const auto* on_curves : {&mesh_.boundary_edges, &mesh_.interface_edges})
    for (const QuadBoundaryEdge& e : *on_curves) edge(e.elem, e.side).is_inside = false;
}

/// The displacement is halved from ring to ring of elements, counted from the curved edges on CAD curves.
void EdgeShaper::fade() {
  std::vector<int> ring(mesh_.num_elems(), 0), elems, next;
  const auto is_source = [&](int e) { return !edges_[e].is_inside && edges_[e].bend > tolerance::tied; };
  for (int elem = 0; elem < mesh_.num_elems(); ++elem)
    if (std::ranges::any_of(elem_edges_[elem], is_source)) ring[elem] = 1, elems.push_back(elem);
  for (; !elems.empty(); elems.swap(next), next.clear())
    for (const int elem : elems)
      for (const int e : elem_edges_[elem])
        for (const int neighbour : edges_[e].elems)
          if (neighbour >= 0 && ring[neighbour] == 0) ring[neighbour] = ring[elem] + 1, next.push_back(neighbour);
  for (Edge& e : edges_)
    for (const int elem : e.elems)
      if (elem >= 0 && ring[elem] > 0) e.factor = std::max(e.factor, std::pow(halved, ring[elem]));
}

Vec2 EdgeShaper::chord_point(int elem, int side, int k) const {
  const Vec2 from = before_.nodes[side_start(mesh_, elem, side)];
  const Vec2 to = before_.nodes[side_start(mesh_, elem, (side + 1) % 4)];
  return (1 - xi_[k]) / 2 * from + (1 + xi_[k]) / 2 * to;
}

double EdgeShaper::bend_of(int elem, int side) const {
  const Vec2 from = before_.nodes[side_start(mesh_, elem, side)];
  const Vec2 to = before_.nodes[side_start(mesh_, elem, (side + 1) % 4)];
  double greatest = 0;
  for (int k = 1; k < mesh_.order; ++k)
    greatest = std::max(greatest, distance(before_.nodes[side_node(mesh_, elem, side, k)], chord_point(elem, side, k)));
  return greatest / std::max(distance(from, to), std::numeric_limits<double>::min());
}

bool EdgeShaper::is_unchanged(int elem) const {
  return std::ranges::all_of(elem_edges_[elem], [&](int e) { return factor(edges_[e]) == 1; });
}

/// Both elements at an edge compute the same nodes up to rounding; that of the first is taken.
void EdgeShaper::place_edges(int elem) {
  for (int side = 0; side < 4; ++side) {
    const Edge& e = edge(elem, side);
    if (!e.is_inside || e.elems[0] != elem) continue;
    for (int k = 1; k < mesh_.order; ++k) {
      const int node = side_node(mesh_, elem, side, k);
      const Vec2 chord = chord_point(elem, side, k);
      mesh_.nodes[node] = e.is_curved ? before_.nodes[node] : chord + e.factor * (before_.nodes[node] - chord);
    }
  }
}

void EdgeShaper::place_inside(int elem) {
  const int n = mesh_.order;
  const auto is_curved = [&](int side) { return edge(elem, side).bend * factor(edge(elem, side)) > tolerance::tied; };
  const std::array<bool, 2> is_linear{is_curved(0) && is_curved(2), is_curved(1) && is_curved(3)};
  const auto shift = [&](int side, int k, double eta) {
    const Vec2 d = mesh_.nodes[side_node(mesh_, elem, side, k)] - chord_point(elem, side, k);
    return (1 - eta) * (is_linear[side % 2] ? 1 : 1 - eta) * d;
  };
  std::array<Vec2, 4> corners;
  for (int c = 0; c < 4; ++c) corners[c] = mesh_.nodes[side_start(mesh_, elem, c)];
  for (int j = 1; j < n; ++j)
    for (int i = 1; i < n; ++i) {
      const double s = (1 + xi_[i]) / 2, t = (1 + xi_[j]) / 2;
      const Vec2 bilinear =
          (1 - t) * ((1 - s) * corners[0] + s * corners[1]) + t * ((1 - s) * corners[3] + s * corners[2]);
      mesh_.nodes[mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + j * (n + 1) + i]] =
          bilinear + shift(0, i, t) + shift(1, j, 1 - s) + shift(2, n - i, 1 - t) + shift(3, n - j, s);
    }
}

/// An element whose edges all keep their curves is that of before.
void EdgeShaper::restore_inside(int elem) {
  const int first = elem * mesh_.nodes_per_elem();
  for (int k = first; k < first + mesh_.nodes_per_elem(); ++k)
    mesh_.nodes[mesh_.elem_nodes[k]] = before_.nodes[mesh_.elem_nodes[k]];
}

bool EdgeShaper::is_worse(int elem) const {
  if (!(mesh_.elem_jacobian_bound[elem] > 0)) return true;
  const double scaled_jacobian = mesh_.elem_scaled_jacobian[elem] + tolerance::tied;
  return scaled_jacobian < good_scaled_jacobian &&
         scaled_jacobian < spectral::quad_scaled_jacobian(mesh_.order, element_nodes(before_, elem).data());
}

/// Of each of these elements the straight edge that bends most, and those that bend as much, keep their curves.
/// Returns the elements at these edges.
std::vector<int> EdgeShaper::restore_curves(const std::vector<int>& elems) {
  std::vector<int> restored, touched;
  for (const int elem : elems) {
    double most = 0;
    for (const int e : elem_edges_[elem])
      if (factor(edges_[e]) < 1) most = std::max(most, edges_[e].bend);
    for (const int e : elem_edges_[elem])
      if (factor(edges_[e]) < 1 && edges_[e].bend >= most * (1 - tolerance::tied)) restored.push_back(e);
  }
  for (const int e : restored) {
    curve_edge(e);
    for (const int elem : edges_[e].elems)
      if (elem >= 0) touched.push_back(elem);
  }
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

void EdgeShaper::run() {
  std::vector<int> elems(mesh_.num_elems());
  for (int elem = 0; elem < mesh_.num_elems(); ++elem) elems[elem] = elem;
  while (!elems.empty()) {
    for (const int elem : elems) place_edges(elem);
    std::vector<int> worse;
    for (const int elem : elems) {
      const bool has_all_curves = is_unchanged(elem);
      has_all_curves ? restore_inside(elem) : place_inside(elem);
      measure_element(mesh_, elem);
      if (!has_all_curves && is_worse(elem)) worse.push_back(elem);
    }
    elems = restore_curves(worse);
  }
  summarise_validity(mesh_);
}

}  // namespace

void shape_inner_edges(QuadMesh& mesh, InnerEdges shape, const std::vector<bool>& kept) {
  if (shape == InnerEdges::curved || mesh.order == 1) return measure_elements(mesh);
  mesh.elem_jacobian_bound.resize(mesh.num_elems());
  mesh.elem_scaled_jacobian.resize(mesh.num_elems());
  EdgeShaper(mesh, shape, kept).run();
}

}  // namespace quadrille::refine
