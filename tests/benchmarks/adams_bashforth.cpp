#include "adams_bashforth.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/project.hpp"
#include "surface/positions.hpp"

namespace quadrille::trace {
namespace {

// x + fraction h (...): the cubic with positions and directions of both ends.
StreamStep hermite(Vec2 x, Vec2 direction, Vec2 end, Vec2 end_direction, double s, double h) {
  const Vec2 rise = end - x, bend = h * direction - rise;
  return {in_the_plane, s, h, h, {x, rise, bend, rise - h * end_direction - bend, {}}};
}

// The nearest point of the boundary beside an element, within a thousandth of the diameter; else curve -1.
ExitPoint boundary_foot_near(const field::FieldEvaluator& evaluator, int elem, Vec2 x) {
  const TriMesh& mesh = evaluator.field().mesh;
  ExitPoint nearest;
  double least = 1e-3 * mesh.face.diameter;
  for (const int edge : evaluator.topology().elem2boundary_edge[elem]) {
    if (edge < 0) continue;
    const BoundaryEdge& boundary = mesh.boundary_edges[edge];
    const curve::Projection foot = curve::project(mesh.face.curves[boundary.curve], x, boundary.t0, boundary.t1);
    const double gap = distance(foot.position, x);
    if (gap >= least) continue;
    least = gap;
    nearest = {boundary.curve, foot.t, foot.position};
  }
  return nearest;
}

class FixedStepIntegrator {
 public:
  FixedStepIntegrator(const field::FieldEvaluator& evaluator, const PointGrid& nodes, const AdvanceOptions& options,
                      Streamline& line)
      : evaluator_(evaluator),
        nodes_(nodes),
        options_(options),
        line_(line),
        at_{line.launch.elem, line.launch.xi},
        x_(line.launch.x),
        angle_(line.launch.angle_there) {}

  void run() {
    const double h = options_.max_step;
    Vec2 f[4];
    if (!direction(x_, f[0])) fail();
    for (int count = 0; count < max_stream_steps && line_.length() <= options_.max_length; ++count) {
      const mesh::Location before = at_;
      Vec2 next;
      const bool is_inside = count < 3 ? runge_kutta(f[0], h, next) : true;
      if (count >= 3) next = x_ + (h / 24) * (55.0 * f[0] - 59.0 * f[1] + 37.0 * f[2] - 9.0 * f[3]);
      Vec2 there;
      if (!is_inside || !direction(next, there)) return approach_boundary(before, f[0], h);
      line_.steps.push_back(hermite(x_, f[0], next, there, line_.length(), h));
      x_ = next;
      for (int i = 3; i > 0; --i) f[i] = f[i - 1];
      f[0] = there;
      if (ends_at_node()) return;
    }
    finish(Streamline::End::length, x_);
  }

 private:
  bool locate(Vec2 x) {
    mesh::Location at = mesh::walk(evaluator_.topology(), evaluator_.maps(), x, at_);
    if (at.elem < 0) at = evaluator_.locator().find(x);
    if (at.elem >= 0) at_ = at;
    return at.elem >= 0;
  }

  // False outside the mesh. Updates angle_.
  bool direction(Vec2 x, Vec2& f) {
    if (!locate(x)) return false;
    Vec2 position;
    Mat2 dx_dxi;
    const Vec2 value = evaluator_.value(at_.elem, at_.xi, position, dx_dxi);
    if (!(norm2(value) > 0)) fail();
    angle_ = guided_angle(value, angle_);
    f = unit(angle_);
    return true;
  }

  bool runge_kutta(Vec2 k1, double h, Vec2& next) {
    Vec2 k2, k3, k4;
    if (!direction(x_ + (h / 2) * k1, k2) || !direction(x_ + (h / 2) * k2, k3) || !direction(x_ + h * k3, k4))
      return false;
    next = x_ + (h / 6) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    return true;
  }

  // The boundary lies within the next step: Runge-Kutta steps of halved length until what remains is round-off.
  void approach_boundary(mesh::Location before, Vec2 f, double h) {
    at_ = before;
    const double angle = angle_of(f);
    angle_ = angle + std::remainder(angle_ - angle, 2 * pi);
    double fraction = 0.5;
    while (h > 1e-13 * evaluator_.field().mesh.face.diameter) {
      const mesh::Location here = at_;
      const double angle_here = angle_;
      Vec2 next, there;
      if (runge_kutta(f, fraction * h, next) && direction(next, there)) {
        line_.steps.push_back(hermite(x_, f, next, there, line_.length(), fraction * h));
        x_ = next, f = there, h *= 1 - fraction;
      } else {
        at_ = here, angle_ = angle_here, h *= fraction;
      }
    }
    const ExitPoint foot = boundary_foot_near(evaluator_, at_.elem, x_);
    if (foot.curve < 0) fail();
    line_.reached = {-1, foot.curve, foot.t};
    finish(Streamline::End::boundary, foot.position);
  }

  bool ends_at_node() {
    const std::vector<Vec2>& nodes = nodes_.points();
    const int node = nodes_.nearest(x_, [&](int n) { return nodes[n] != line_.launch.origin; }).point;
    if (node < 0 || distance(x_, nodes[node]) > options_.hit_distance) return false;
    line_.reached = {node, -1, 0};
    finish(Streamline::End::node, nodes[node]);
    return true;
  }

  void finish(Streamline::End how, Vec2 where) {
    line_.end = how;
    line_.end_position = where;
    line_.end_angle = angle_;
    line_.front.state = {at_.elem, at_.xi, angle_, {}};
  }

  [[noreturn]] void fail() const {
    throw ComputeError(fmt::format(
        "a separatrix cannot be followed beyond {}: the field has no direction there, or a step jumps over the "
        "boundary",
        surface::position_text(evaluator_.field().mesh.face, x_)));
  }

  const field::FieldEvaluator& evaluator_;
  const PointGrid& nodes_;
  const AdvanceOptions& options_;
  Streamline& line_;
  mesh::Location at_;
  Vec2 x_;
  double angle_;
};

}  // namespace

Streamline advance_adams_bashforth(const field::FieldEvaluator& evaluator, const Launch& launch, const PointGrid& nodes,
                                   const AdvanceOptions& options) {
  Streamline line;
  line.launch = launch;
  FixedStepIntegrator(evaluator, nodes, options, line).run();
  return line;
}

}  // namespace quadrille::trace
