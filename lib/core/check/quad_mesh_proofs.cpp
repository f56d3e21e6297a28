// Rules of quad meshes that are proofs, or need the surface.

#include "check/rules.hpp"
#include "curve/nearest_along.hpp"
#include "spectral/quad_map.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::check {

namespace {

constexpr double boundary_tol = 1e-9;  ///< diameters: of boundary nodes from their curves in space

template <typename Point>
std::vector<Point> element_nodes(const QuadMesh& mesh, const std::vector<Point>& nodes, int elem) {
  std::vector<Point> own;
  for (int i = 0; i < mesh.nodes_per_elem(); ++i)
    own.push_back(nodes[mesh.elem_nodes[elem * mesh.nodes_per_elem() + i]]);
  return own;
}

double proved_bound(const QuadMesh& mesh, int elem) {
  if (mesh.space_nodes.empty())
    return spectral::quad_jacobian_lower_bound(mesh.order, element_nodes(mesh, mesh.nodes, elem).data());
  return spectral::quad_normal_lower_bound(mesh.order, element_nodes(mesh, mesh.space_nodes, elem).data());
}

}  // namespace

void jacobians_are_as_stored(const QuadMesh& mesh, Findings& findings) {
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (!(mesh.elem_jacobian_bound[e] > 0)) continue;
    if (const double bound = proved_bound(mesh, e); !(bound > 0))
      findings.add("element {} is not proved valid: its Jacobian's lower bound is {:.3g}, at {}", e, bound,
                   position_text(mesh.face, mesh.nodes[side_node(mesh, e, 0, 0)]));
  }
}

void boundary_is_on_curves_in_space(const QuadMesh& mesh, Findings& findings) {
  if (mesh.space_nodes.empty()) return;
  const curve::FaceBoundary boundary(mesh.face);
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& edge : *edges)
      for (const int node : side_nodes(mesh, edge.elem, edge.side)) {
        const curve::NearestPoint at = curve::nearest_along(boundary, edge.curve, mesh.nodes[node]);
        const double off =
            distance(surface::point(mesh.face.chart->space_curves[at.curve], at.t), mesh.space_nodes[node]);
        if (!(off <= boundary_tol * mesh.face.diameter))
          findings.add("node {} on curve {} lies {:.3g} away from the curve in space, at {}", node, edge.curve, off,
                       position_text(mesh.face, mesh.nodes[node]));
      }
}

}  // namespace quadrille::check
