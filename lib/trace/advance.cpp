#include "trace/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/project.hpp"

namespace quadrille::trace {
namespace {

// A point counts as outside an element from here on, in barycentric coordinates: keeps a line that grazes an edge from
// going to and fro without advancing.
constexpr double edge_slack = 1e-12;
constexpr double same_direction = 1e-3;  // radians
/// A lap is longer than this many hit distances: a line that runs along an edge goes over it again and again.
constexpr double least_lap = 100;
constexpr double overshoot = 0.05;  // how far a step may extrapolate beyond the element

// Barycentric coordinate that vanishes on local edge k, and its linear part.
double above_edge(int k, Vec2 xi) { return k == 0 ? (1 + xi.y) / 2 : k == 1 ? -(xi.x + xi.y) / 2 : (1 + xi.x) / 2; }
double above_edge_rate(int k, Vec2 rate) { return k == 0 ? rate.y / 2 : k == 1 ? -(rate.x + rate.y) / 2 : rate.x / 2; }

// Fraction along local edge k, as in tri_edge_point.
double along_edge(int k, Vec2 xi) {
  const double f = k == 0 ? (1 + xi.x) / 2 : k == 1 ? (1 + xi.y) / 2 : (1 - xi.y) / 2;
  return std::clamp(f, 0.0, 1.0);
}

// Share of the step at which it crosses edge k outwards; the step's end lies outside.
double crossing_share(const StreamStep& step, int k) {
  double a = 0, b = 1, fa = above_edge(k, step.xi(0)), fb = above_edge(k, step.xi(1));
  if (fa <= 0) return 0;
  for (int i = 0; i < 100; ++i) {
    // False position, with a bisection every third time.
    double m = i % 3 == 2 ? (a + b) / 2 : a + (b - a) * fa / (fa - fb);
    if (m <= a || m >= b) m = (a + b) / 2;
    if (m <= a || m >= b) break;
    const double f = above_edge(k, step.xi(m));
    (f > 0 ? a : b) = m;
    (f > 0 ? fa : fb) = f;
    if (b - a < 1e-15 || std::abs(f) < 1e-16) return m;
  }
  return b;
}

struct Exit {
  int edge = -1;
  double share = 2;
};

Exit first_exit(const StreamStep& step) {
  Exit exit;
  const Vec2 last = step.xi(1);
  for (int k = 0; k < 3; ++k) {
    if (above_edge(k, last) >= -edge_slack) continue;
    const double share = crossing_share(step, k);
    if (share < exit.share) exit = {k, share};
  }
  return exit;
}

class Walker {
 public:
  // Begins at the line's front.
  Walker(const field::FieldEvaluator& evaluator, const std::vector<Vec2>& nodes, const AdvanceOptions& options,
         Streamline& line)
      : evaluator_(evaluator),
        nodes_(nodes),
        options_(options),
        line_(line),
        state_(line.front),
        s_(line.length()),
        h_(line.next_step),
        is_near_origin_(line.steps.empty()) {
    nearest_node(evaluator.maps()[state_.elem].position(state_.xi));
  }

  void walk() {
    for (int count = static_cast<int>(line_.steps.size()); count < max_stream_steps; ++count) {
      if (s_ > options_.max_length)
        return finish(Streamline::End::length, evaluator_.maps()[state_.elem].position(state_.xi));
      StreamStep step;
      StreamState end;
      accepted_step(step, end);
      const Exit exit = first_exit(step);
      if (exit.edge >= 0) {
        if (leave_element(step, exit)) return;
        if (was_here(step.elem, exit.edge)) {
          line_.is_limit_cycle = true;
          return finish(Streamline::End::length, evaluator_.maps()[state_.elem].position(state_.xi));
        }
      } else {
        push(step);
        state_ = end;
      }
      if (ends_at_node(evaluator_.maps()[state_.elem].position(state_.xi))) return;
    }
    finish(Streamline::End::length, evaluator_.maps()[state_.elem].position(state_.xi));
  }

 private:
  void accepted_step(StreamStep& step, StreamState& end) {
    h_ = std::min({h_, options_.max_step, reach(), room_});
    for (;;) {
      double error = 0;
      try_step(evaluator_, state_, h_, step, end, error);
      const double ratio = error / options_.tolerance;
      const double factor = !std::isfinite(ratio) ? 0.25 : ratio > 0 ? 0.9 * std::pow(ratio, -0.2) : 5.0;
      if (ratio <= 1) {
        step.s = s_;
        h_ *= std::clamp(factor, 0.2, 5.0);
        return;
      }
      h_ *= std::clamp(factor, 0.1, 0.9);
      if (h_ < 1e-7 * options_.tolerance || h_ < 1e-15 * s_) fail();
    }
  }

  // Length after which the tangent has left the element by the overshoot.
  double reach() const {
    double length = options_.max_step;
    for (int k = 0; k < 3; ++k) {
      const double rate = above_edge_rate(k, state_.rate);
      if (rate < 0) length = std::min(length, (std::max(0.0, above_edge(k, state_.xi)) + overshoot) / -rate);
    }
    return length;
  }

  void push(const StreamStep& step) {
    if (step.length > 0) line_.steps.push_back(step);
    s_ += step.length;
  }

  // Goes over to the neighbour; true when the line ends on the boundary.
  bool leave_element(StreamStep& step, const Exit& exit) {
    step.length = exit.share * step.h;
    push(step);
    const int elem = step.elem;
    const double fraction = along_edge(exit.edge, step.xi(exit.share));
    const mesh::TriTopology& topology = evaluator_.topology();
    const int neighbor = topology.elem2neighbors[elem][exit.edge];
    state_.angle = angle_at(step, exit.share);
    if (neighbor < 0) {
      const int edge = topology.elem2boundary_edge[elem][exit.edge];
      const BoundaryEdge& boundary = evaluator_.field().mesh.boundary_edges[edge];
      const Vec2 x = evaluator_.maps()[elem].position(step.xi(exit.share));
      const Nurbs& curve = evaluator_.field().mesh.face.curves[boundary.curve];
      const curve::Projection foot = curve::project(curve, x, boundary.t0, boundary.t1);
      state_.angle = stream_state(evaluator_, elem, step.xi(exit.share), state_.angle).angle;
      if (ends_at_node(foot.position)) return true;
      line_.curve = boundary.curve;
      line_.t = foot.t;
      finish(Streamline::End::boundary, foot.position);
      return true;
    }
    const int edge = topology.elem2neighbor_edges[elem][exit.edge];
    state_ = stream_state(evaluator_, neighbor, spectral::tri_edge_point(edge, 1 - fraction), state_.angle);
    return false;
  }

  // Whether it has just gone over an edge as it did a lap before.
  bool was_here(int elem, int edge) {
    const auto [pass, is_first] = line_.passes.try_emplace(3 * elem + edge, Streamline::Pass{state_, s_});
    if (is_first) return false;
    const Streamline::Pass before = std::exchange(pass->second, Streamline::Pass{state_, s_});
    const spectral::TriMap& map = evaluator_.maps()[state_.elem];
    return s_ - before.s > least_lap * options_.hit_distance &&
           std::abs(wrap_pi(state_.angle - before.state.angle)) < same_direction &&
           distance(map.position(state_.xi), map.position(before.state.xi)) <= options_.hit_distance;
  }

  // Of the continuous extension: as good a guide as the field's own.
  double angle_at(const StreamStep& step, double share) const {
    Vec2 x;
    Mat2 dx_dxi;
    evaluator_.maps()[step.elem].evaluate(step.xi(share), x, dx_dxi);
    return state_.angle + wrap_pi(angle_of(dx_dxi * step.slope(share)) - state_.angle);
  }

  bool ends_at_node(Vec2 x) {
    const double hit = options_.hit_distance;
    if (distance(x, line_.launch.origin) > 10 * hit) is_near_origin_ = false;
    const int node = nearest_node(x);
    if (node < 0 || distance(x, nodes_[node]) > hit) return false;
    line_.end_node = node;
    finish(Streamline::End::node, nodes_[node]);
    return true;
  }

  // Of nodes other than the line's own, before it has left that. Sets room_: the field has a singularity there, which
  // the error of a longer step might not know of.
  int nearest_node(Vec2 x) {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity(), least_other = least;
    for (size_t n = 0; n < nodes_.size(); ++n) {
      const double gap2 = norm2(x - nodes_[n]);
      const bool is_own = nodes_[n] == line_.launch.origin;
      if (!is_own) least_other = std::min(least_other, gap2);
      if (gap2 < least && !(is_own && is_near_origin_)) least = gap2, nearest = static_cast<int>(n);
    }
    room_ = std::sqrt(least_other) / 2;
    return nearest;
  }

  void finish(Streamline::End how, Vec2 where) {
    line_.end = how;
    line_.end_position = where;
    line_.end_angle = state_.angle;
    line_.front = state_;
    line_.next_step = h_;
  }

  [[noreturn]] void fail() const {
    const Vec2 origin = evaluator_.field().mesh.face.origin;
    const Vec2 from = line_.launch.origin + origin;
    const Vec2 at = evaluator_.maps()[state_.elem].position(state_.xi) + origin;
    throw ComputeError(
        fmt::format("the separatrix from ({:.6g}, {:.6g}) at {:.2f} degrees cannot be followed beyond "
                    "({:.6g}, {:.6g}): the field has no direction there",
                    from.x, from.y, degrees(wrap_pi(line_.launch.angle)), at.x, at.y));
  }

  const field::FieldEvaluator& evaluator_;
  const std::vector<Vec2>& nodes_;
  const AdvanceOptions& options_;
  Streamline& line_;
  StreamState state_;
  double s_, h_, room_ = 0;
  bool is_near_origin_;  // has not left its node yet
};

}  // namespace

// From the node to the first point: the cubic with both directions.
Vec2 Streamline::lead_in(double s, Vec2& direction) const {
  const double r = launch.radius, f = r > 0 ? s / r : 0;
  const Vec2 d0 = r * unit(launch.angle), d1 = r * unit(launch.angle_there), rise = launch.x - launch.origin;
  const Vec2 c2 = 3 * rise - 2 * d0 - d1, c3 = d0 + d1 - 2 * rise;
  direction = r > 0 ? normalized(d0 + 2 * f * c2 + 3 * f * f * c3) : unit(launch.angle);
  return launch.origin + f * (d0 + f * (c2 + f * c3));
}

Vec2 Streamline::at(const field::FieldEvaluator& evaluator, double s, Vec2& direction) const {
  if (s <= launch.radius || steps.empty()) return lead_in(std::max(s, 0.0), direction);
  if (s >= length()) {
    direction = unit(end_angle);
    return end_position;
  }
  const auto after =
      std::upper_bound(steps.begin(), steps.end(), s, [](double v, const StreamStep& k) { return v < k.s; });
  const StreamStep& step = after == steps.begin() ? steps.front() : *(after - 1);
  const double theta = std::clamp((s - step.s) / step.h, 0.0, 1.0);
  if (step.elem == in_the_plane) {
    direction = normalized(step.slope(theta));
    return step.xi(theta);
  }
  Vec2 x;
  Mat2 dx_dxi;
  evaluator.maps()[step.elem].evaluate(step.xi(theta), x, dx_dxi);
  direction = normalized(dx_dxi * step.slope(theta));
  return x;
}

Vec2 Streamline::at(const field::FieldEvaluator& evaluator, double s) const {
  Vec2 direction;
  return at(evaluator, s, direction);
}

std::vector<double> Streamline::step_ends() const {
  std::vector<double> ends{0};
  for (const StreamStep& step : steps) ends.push_back(step.s);
  ends.push_back(length());
  return ends;
}

Streamline advance(const field::FieldEvaluator& evaluator, const Launch& launch, const std::vector<Vec2>& nodes,
                   const AdvanceOptions& options) {
  Streamline line;
  line.launch = launch;
  line.front = stream_state(evaluator, launch.elem, launch.xi, launch.angle_there);
  line.next_step = std::max(launch.radius, 1e-3 * options.max_step);
  Walker(evaluator, nodes, options, line).walk();
  return line;
}

void follow(const field::FieldEvaluator& evaluator, Streamline& line, const std::vector<Vec2>& nodes,
            const AdvanceOptions& options) {
  if (line.end == Streamline::End::length && !line.is_limit_cycle) Walker(evaluator, nodes, options, line).walk();
}

}  // namespace quadrille::trace
