#include "triangulate/sort_by_region.hpp"

#include <algorithm>
#include <numeric>

#include "base/disjoint_sets.hpp"

namespace quadrille::triangulate {
namespace {

// Of each vertex. Every connected part of the mesh has edges on the boundary of its region.
std::vector<int> regions_of_vertices(const TriMesh& mesh) {
  DisjointSets parts(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.elem2vertices) {
    parts.unite(a, b);
    parts.unite(b, c);
  }
  std::vector<int> region_of_part(mesh.vertices.size(), 0), regions;
  for (const BoundaryEdge& edge : mesh.boundary_edges)
    region_of_part[parts.find(mesh.elem2vertices[edge.elem].front())] =
        mesh.face.region_of_loop(mesh.face.loop_of(edge.curve));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    regions.push_back(region_of_part[parts.find(static_cast<int>(v))]);
  return regions;
}

// The numbers 0, 1, ... sorted by their regions.
std::vector<int> order_of(const std::vector<int>& regions) {
  std::vector<int> order(regions.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return regions[a] < regions[b]; });
  return order;
}

std::vector<int> inverse_of(const std::vector<int>& order) {
  std::vector<int> inverse(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) inverse[order[i]] = static_cast<int>(i);
  return inverse;
}

template <typename T>
void permute(std::vector<T>& values, const std::vector<int>& order) {
  const std::vector<T> before = values;
  for (std::size_t i = 0; i < order.size(); ++i) values[i] = before[order[i]];
}

}  // namespace

std::vector<int> sort_by_region(TriMesh& mesh) {
  std::vector<int> vertices(mesh.vertices.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  if (mesh.face.num_regions() == 1) return vertices;
  const std::vector<int> regions = regions_of_vertices(mesh);
  std::vector<int> region_of_elem;
  for (const auto& triangle : mesh.elem2vertices) region_of_elem.push_back(regions[triangle.front()]);
  vertices = order_of(regions);
  const std::vector<int> elems = order_of(region_of_elem), new_vertices = inverse_of(vertices),
                         new_elems = inverse_of(elems);
  permute(mesh.vertices, vertices);
  permute(mesh.elem2vertices, elems);
  permute(mesh.elem_layer, elems);
  for (auto& triangle : mesh.elem2vertices)
    for (int& v : triangle) v = new_vertices[v];
  for (BoundaryEdge& edge : mesh.boundary_edges) edge.elem = new_elems[edge.elem];
  mesh.region_elems.assign(mesh.face.num_regions() + 1, 0);
  for (const int r : region_of_elem) ++mesh.region_elems[r + 1];
  std::partial_sum(mesh.region_elems.begin(), mesh.region_elems.end(), mesh.region_elems.begin());
  return vertices;
}

}  // namespace quadrille::triangulate
