#include "export/skeleton.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace quadrille::exports {
namespace {

/// An edge seen from one element: its end nodes, the lower first.
struct HalfEdge {
  int low, high, elem, side;
};

std::vector<HalfEdge> sorted_half_edges(const QuadMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(4 * mesh.num_elems());
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const int a = side_start(mesh, elem, side), b = side_start(mesh, elem, (side + 1) % 4);
      edges.push_back({std::min(a, b), std::max(a, b), elem, side});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.elem, a.side) < std::tie(b.low, b.high, b.elem, b.side);
  });
  return edges;
}

struct Interface {
  SkeletonEdge edge;         ///< seen from the element of lower number, which lies on its left
  std::array<int, 2> nodes;  ///< from, to
  int right_block;
  int cad_curve;  ///< -1 inside a region
};

/// By element and side: the CAD curve of an edge on an interface, else -1.
std::vector<int> interface_curves(const QuadMesh& mesh) {
  std::vector<int> curves(4 * mesh.elem_block.size(), -1);
  for (const QuadBoundaryEdge& e : mesh.interface_edges) curves[4 * e.elem + e.side] = e.curve;
  return curves;
}

std::vector<Interface> interfaces(const QuadMesh& mesh) {
  std::vector<Interface> found;
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  const std::vector<int> curves = interface_curves(mesh);
  const auto curve_of = [&](const HalfEdge& h) { return curves[4 * h.elem + h.side]; };
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const HalfEdge &a = edges[k - 1], &b = edges[k];
    if (a.low != b.low || a.high != b.high) continue;
    const int block_a = mesh.elem_block[a.elem], block_b = mesh.elem_block[b.elem];
    if (block_a == block_b && curve_of(a) < 0) continue;
    // The lower curve, or else the lower block, lies on the left, so that all edges between two blocks run the same
    // way.
    const bool a_left = curve_of(a) >= 0 ? curve_of(a) < curve_of(b) : block_a < block_b;
    const HalfEdge &left = a_left ? a : b, &right = a_left ? b : a;
    found.push_back({{left.elem, left.side},
                     {side_start(mesh, left.elem, left.side), side_start(mesh, left.elem, (left.side + 1) % 4)},
                     mesh.elem_block[right.elem],
                     curve_of(left)});
  }
  return found;
}

class Builder {
 public:
  explicit Builder(const QuadMesh& mesh)
      : mesh_(mesh), interfaces_(interfaces(mesh)), degree_(mesh.nodes.size(), 0), point_(mesh.nodes.size(), -1) {
    std::vector<int> curve_at(mesh.nodes.size(), -1);
    is_junction_.assign(mesh.nodes.size(), false);
    for (const Interface& i : interfaces_)
      for (const int node : i.nodes) {
        if (degree_[node]++ > 0 && curve_at[node] != i.cad_curve) is_junction_[node] = true;
        curve_at[node] = i.cad_curve;
      }
    for (std::size_t node = 0; node < degree_.size(); ++node)
      is_junction_[node] = is_junction_[node] || (degree_[node] != 0 && degree_[node] != 2);
    for (const QuadBoundaryEdge& e : mesh.boundary_edges)
      for (const int node : {side_start(mesh, e.elem, e.side), side_start(mesh, e.elem, (e.side + 1) % 4)})
        if (degree_[node] > 0) is_junction_[node] = true;
  }

  Skeleton build() {
    add_boundary_curves();
    add_interface_curves();
    return std::move(skeleton_);
  }

 private:
  int point_at(int node) {
    if (point_[node] < 0) {
      point_[node] = static_cast<int>(skeleton_.points.size());
      skeleton_.points.push_back(node);
    }
    return point_[node];
  }

  void add_boundary_curves() {
    int previous_end = -1;
    for (const QuadBoundaryEdge& e : mesh_.boundary_edges) {
      const int start = side_start(mesh_, e.elem, e.side), end = side_start(mesh_, e.elem, (e.side + 1) % 4);
      const bool continues =
          start == previous_end && !is_junction_[start] && skeleton_.curves.back().cad_curve == e.curve;
      if (!continues) {
        skeleton_.curves.push_back({e.curve, point_at(start), 0, {mesh_.elem_block[e.elem], -1}, {}});
        if (previous_end >= 0) close(skeleton_.curves[skeleton_.curves.size() - 2], previous_end);
      }
      skeleton_.curves.back().edges.push_back({e.elem, e.side});
      previous_end = end;
    }
    if (previous_end >= 0) close(skeleton_.curves.back(), previous_end);
  }

  void close(SkeletonCurve& curve, int node) { curve.to = point_at(node); }

  void add_interface_curves() {
    std::map<int, std::vector<int>> outgoing;  // node -> interfaces that start there
    for (std::size_t k = 0; k < interfaces_.size(); ++k)
      outgoing[interfaces_[k].nodes[0]].push_back(static_cast<int>(k));
    used_.assign(interfaces_.size(), false);
    for (const bool from_junctions : {true, false})  // the interfaces that remain form closed rings
      for (std::size_t k = 0; k < interfaces_.size(); ++k)
        if (!used_[k] && (!from_junctions || is_junction_[interfaces_[k].nodes[0]]))
          walk(static_cast<int>(k), outgoing);
  }

  void walk(int first, const std::map<int, std::vector<int>>& outgoing) {
    const int left_block = mesh_.elem_block[interfaces_[first].edge.elem];
    SkeletonCurve curve{interfaces_[first].cad_curve,
                        point_at(interfaces_[first].nodes[0]),
                        0,
                        {left_block, interfaces_[first].right_block},
                        {}};
    for (int k = first; k >= 0;) {
      used_[k] = true;
      curve.edges.push_back(interfaces_[k].edge);
      const int node = interfaces_[k].nodes[1];
      k = -1;
      const auto next = outgoing.find(node);
      if (!is_junction_[node] && next != outgoing.end() && !used_[next->second.front()]) k = next->second.front();
      if (k < 0) close(curve, node);
    }
    skeleton_.curves.push_back(std::move(curve));
  }

  const QuadMesh& mesh_;
  std::vector<Interface> interfaces_;
  std::vector<int> degree_, point_;  ///< by mesh node: interfaces that end there; its point or -1
  std::vector<bool> is_junction_, used_;
  Skeleton skeleton_;
};

}  // namespace

Skeleton mesh_skeleton(const QuadMesh& mesh) { return Builder(mesh).build(); }

}  // namespace quadrille::exports
