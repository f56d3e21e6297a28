#include "galerkin/phase_request.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/nurbs.hpp"
#include "surface/positions.hpp"

namespace quadrille::galerkin {
namespace {

// lib/method.md §5: a sharp corner needs one block in any case. The tolerance admits corners that equal a bound up to
// rounding.
constexpr double least_degrees = 15 - 1e-6, greatest_degrees = 165 + 1e-6;

bool is_admissible(double angle, int valence) {
  if (valence == 0) return true;
  const double block = degrees(angle) / valence;
  return valence > 0 && (valence == 1 || least_degrees <= block) && block <= greatest_degrees;
}

void require_admissible(const CadFace& face, double angle, int valence, Vec2 position, const std::string& what) {
  if (is_admissible(angle, valence)) return;
  throw ComputeError(
      fmt::format("{} at {} cannot have valence {}: its angle is {:.6g} degrees, and blocks need 15 to 165 degrees",
                  what, surface::position_text(face, position), valence, degrees(angle)));
}

void require_admissible_valences(const CadFace& face, const PhaseNodes& asked) {
  for (const CornerValence& corner : asked.corners) {
    if (corner.joint < 0 || corner.joint >= face.num_curves()) continue;  // reported by PhaseBoundary
    const Joint& joint = face.joints[corner.joint];
    require_admissible(
        face, joint.interior_angle, corner.valence, joint.position,
        fmt::format("the corner of curves {} and {}", face.previous_in_loop(corner.joint), corner.joint));
  }
  for (const BoundaryNode& node : asked.boundary_nodes) {
    if (node.curve < 0 || node.curve >= face.num_curves()) continue;
    require_admissible(face, pi, node.valence, curve::point(face.curves[node.curve], node.t),
                       fmt::format("the boundary node on curve {}", node.curve));
  }
}

}  // namespace

void require_possible(PhaseSolver& solver, const CadFace& face, const PhaseNodes& asked, const std::string& name) {
  try {
    require_admissible_valences(face, asked);
    solver.set_nodes(asked);
  } catch (const ComputeError& error) {
    throw FormatError(fmt::format("{}: {}", name, error.what()));
  }
}

std::vector<int> phase_orders(const TriMesh& mesh, const std::vector<int>& field_orders) {
  constexpr int more_than_half = 5;
  std::vector<int> orders = field_orders;
  for (std::size_t e = 0; e < orders.size(); ++e)
    if (mesh.elem_layer[e] < 0) orders[e] = std::min(orders[e], (orders[e] + 1) / 2 + more_than_half);
  for (const BoundaryEdge& edge : mesh.boundary_edges)
    if (mesh.face.curves[edge.curve].degree == 1) orders[edge.elem] = field_orders[edge.elem];
  return orders;
}

}  // namespace quadrille::galerkin
