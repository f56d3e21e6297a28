// Rules of quad meshes that are proofs, or need the surface.

#include <cmath>

#include "check/rules.hpp"
#include "curve/project.hpp"
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

namespace {

/// Of the points of a boundary curve and of its two neighbours in the loop (an edge may pass a joint) with the
/// parameters nearest to x, that of the nearest one.
Vec3 on_space_boundary(const CadFace& face, int curve, Vec2 x) {
  curve::Projection nearest{0, {}, HUGE_VAL};
  int nearest_curve = curve;
  for (const int c : {curve, face.previous_in_loop(curve), face.next_in_loop(curve)})
    if (const curve::Projection foot = curve::project(face.curves[c], x); foot.distance < nearest.distance)
      nearest = foot, nearest_curve = c;
  return surface::point(face.chart->space_curves[nearest_curve], nearest.t);
}

}  // namespace

void boundary_is_on_curves_in_space(const QuadMesh& mesh, Findings& findings) {
  if (mesh.space_nodes.empty()) return;
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& edge : *edges)
      for (const int node : side_nodes(mesh, edge.elem, edge.side)) {
        const double off = distance(on_space_boundary(mesh.face, edge.curve, mesh.nodes[node]), mesh.space_nodes[node]);
        if (!(off <= boundary_tol * mesh.face.diameter))
          findings.add("node {} on curve {} lies {:.3g} away from the curve in space, at {}", node, edge.curve, off,
                       position_text(mesh.face, mesh.nodes[node]));
      }
}

}  // namespace quadrille::check
