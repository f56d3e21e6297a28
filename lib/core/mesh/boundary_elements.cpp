#include "mesh/boundary_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>

namespace quadrille::mesh {
namespace {

double edge_length(const QuadMesh& mesh, const QuadBoundaryEdge& edge) {
  const int start = side_node(mesh, edge.elem, edge.side, 0), end = side_node(mesh, edge.elem, edge.side, mesh.order);
  return mesh.space_nodes.empty() ? distance(mesh.nodes[start], mesh.nodes[end])
                                  : distance(mesh.space_nodes[start], mesh.space_nodes[end]);
}

/// The other side of a curve between elements is counted.
bool is_second_side(const CadFace& face, int curve) { return face.is_interface(curve) && face.partners[curve] < curve; }

}  // namespace

std::vector<BoundaryElements> boundary_elements(const QuadMesh& mesh) {
  const CadFace& face = mesh.face;
  std::map<std::string, std::size_t> numbers;
  std::vector<BoundaryElements> found;
  for (const std::string& name : face.curve_names)
    if (numbers.emplace(name, found.size()).second) found.push_back({name});
  for (const auto* const edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& edge : *edges) {
      if (is_second_side(face, edge.curve)) continue;
      BoundaryElements& along = found[numbers.at(face.curve_names[edge.curve])];
      const double length = edge_length(mesh, edge);
      along.least_edge = along.count == 0 ? length : std::min(along.least_edge, length);
      along.greatest_edge = std::max(along.greatest_edge, length);
      ++along.count;
    }
  std::erase_if(found, [](const BoundaryElements& along) { return along.count == 0; });
  return found;
}

void report_boundary_elements(const QuadMesh& mesh, Report& report) {
  int number = 0;
  for (const BoundaryElements& along : boundary_elements(mesh)) {
    const std::string key = fmt::format("boundaries.{}.", number++);
    report.set(key + "name", along.name);
    report.set(key + "elements", along.count);
    report.set(key + "least_edge", along.least_edge);
    report.set(key + "greatest_edge", along.greatest_edge);
  }
}

}  // namespace quadrille::mesh
