#include "trace/launch.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.hpp"
#include "base/bracketed_root.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::trace {
namespace {

// The direction of the field's cross nearest to `direction` at x; false outside the mesh. `at`: where to look first.
bool direction_at(const field::FieldEvaluator& evaluator, Vec2 x, double direction, mesh::Location& at, double& found) {
  Vec2 value;
  if (!evaluator.value_near(x, at, value)) return false;
  found = guided_angle(value, direction);
  return true;
}

// Bearing offset beta: the direction at origin + radius e(angle + beta) is angle + (1 + power) beta. The root is
// bracketed because the direction nearly jumps next to corners of 45, 135, ... degrees. False when the first point lies
// outside the domain.
bool bend_launch(const field::FieldEvaluator& evaluator, Vec2 origin, double angle, double radius, double power,
                 double& beta) {
  bool inside = true;
  mesh::Location at;
  const auto residual = [&](double b) {
    double direction = angle;
    if (!direction_at(evaluator, origin + radius * unit(angle + b), angle, at, direction)) inside = false;
    return direction - angle - (1 + power) * b;
  };
  beta = 0;
  residual(0);
  if (!inside) return false;
  double width = 1e-12;
  while ((width *= 4) < 0.2) {
    const double low = residual(-width), high = residual(width);
    if (!inside) break;
    if ((low < 0) == (high < 0)) continue;
    // Rounding of directions is a few 1e-16: nothing smaller is sought.
    const double falling = low < 0 ? -0.1 : 0.1;
    beta =
        width * (2 * falling_root_to_round_off([&](double f) { return falling * residual(width * (2 * f - 1)); }) - 1);
    return true;
  }
  return true;  // no such direction nearby: the line starts straight
}

}  // namespace

Launch launch_line(const field::FieldEvaluator& evaluator, int node, Vec2 origin, double angle, double radius,
                   double power) {
  for (int attempt = 0; attempt < 6; ++attempt, radius /= 10) {
    double beta = 0;
    if (!bend_launch(evaluator, origin, angle, radius, power, beta)) continue;
    mesh::Location at = evaluator.locator().find(origin + radius * unit(angle + beta));
    if (at.elem < 0) continue;
    Launch launch{{node, -1, 0}, origin, angle, radius, at.elem, at.xi, evaluator.maps()[at.elem].position(at.xi),
                  angle};
    if (!direction_at(evaluator, launch.x, angle, at, launch.angle_there)) continue;
    return launch;
  }
  throw ComputeError(fmt::format("the separatrix from {} at {:.2f} degrees starts outside the mesh",
                                 position_text(origin + evaluator.field().mesh.face.origin), degrees(wrap_pi(angle))));
}

Launch launch_from_boundary(const field::FieldEvaluator& evaluator, int curve, double t) {
  const TriMesh& mesh = evaluator.field().mesh;
  const Nurbs& c = mesh.face.curves[curve];
  const Vec2 x = curve::point(c, t);
  const double angle = angle_of(left_of(curve::tangent(c, t)));
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    if (edge.curve != curve || t < edge.t0 || t > edge.t1) continue;
    const double fraction = (t - edge.t0) / (edge.t1 - edge.t0);
    Vec2 xi = spectral::tri_edge_point(edge.edge, fraction);
    if (!evaluator.maps()[edge.elem].invert(x, xi)) xi = spectral::tri_edge_point(edge.edge, fraction);
    return {{-1, curve, t}, x, angle, 0, edge.elem, xi, x, angle};
  }
  throw Defect("launch_from_boundary: no boundary edge contains the parameter");
}

}  // namespace quadrille::trace
