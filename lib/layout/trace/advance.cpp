#include "trace/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/project.hpp"
#include "surface/positions.hpp"

namespace quadrille::trace {
namespace {

// A lap is longer than this many hit distances: a line that runs along an edge crosses it again and again.
constexpr double least_lap = 100;

// Whether a line that has just crossed an edge, and is now at `state` after arc length `s`, crosses it as it did a lap
// before. Records the crossing.
bool closes_lap(const field::FieldEvaluator& evaluator, const StreamState& state, double s, double hit_distance,
                int edge_key, Streamline& line) {
  const auto [pass, is_first] = line.front.passes.try_emplace(edge_key, Streamline::Pass{state, s});
  if (is_first) return false;
  const Streamline::Pass before = std::exchange(pass->second, Streamline::Pass{state, s});
  const spectral::TriMap& map = evaluator.maps()[state.elem];
  return s - before.s > least_lap * hit_distance &&
         std::abs(wrap_pi(state.angle - before.state.angle)) < same_direction &&
         distance(map.position(state.xi), map.position(before.state.xi)) <= hit_distance;
}

// The direction of the continuous extension nearest to `near`: as accurate as the direction of the field.
double direction_of(const field::FieldEvaluator& evaluator, const StreamStep& step, double fraction, double near) {
  Vec2 x;
  Mat2 dx_dxi;
  evaluator.maps()[step.elem].evaluate(step.xi(fraction), x, dx_dxi);
  return near + wrap_pi(angle_of(dx_dxi * step.slope(fraction)) - near);
}

// The point of the CAD curve nearest to where a step crosses an element's edge on the boundary.
ExitPoint boundary_foot(const field::FieldEvaluator& evaluator, const StreamStep& step, const ElementExit& exit) {
  const TriMesh& mesh = evaluator.field().mesh;
  const BoundaryEdge& edge = mesh.boundary_edges[evaluator.topology().elem2boundary_edge[step.elem][exit.edge]];
  const Vec2 x = evaluator.maps()[step.elem].position(step.xi(exit.fraction));
  const curve::Projection foot = curve::project(mesh.face.curves[edge.curve], x, edge.t0, edge.t1);
  return {edge.curve, foot.t, foot.position};
}

[[noreturn]] void fail_without_direction(const field::FieldEvaluator& evaluator, const Streamline& line, Vec2 x) {
  const CadFace& face = evaluator.field().mesh.face;
  throw ComputeError(
      fmt::format("the separatrix from {} at {:.2f} degrees cannot be followed beyond {}: "
                  "the field has no direction there",
                  surface::position_text(face, line.launch.origin), degrees(wrap_pi(line.launch.angle)),
                  surface::position_text(face, x)));
}

// Begins at the line's front.
class StreamlineIntegrator {
 public:
  StreamlineIntegrator(const field::FieldEvaluator& evaluator, const PointGrid& nodes, const AdvanceOptions& options,
                       Streamline& line)
      : evaluator_(evaluator),
        nodes_(nodes),
        options_(options),
        line_(line),
        proximity_(nodes, line.launch.origin, line.steps.empty()),
        state_(line.front.state),
        s_(line.length()),
        h_(line.front.next_step) {
    proximity_.move_to(position());
  }

  void run() {
    for (int count = static_cast<int>(line_.steps.size()); count < max_stream_steps; ++count) {
      if (s_ > options_.max_length) break;
      if (advance_by_a_step()) return;
    }
    finish(Streamline::End::length, position());
  }

 private:
  Vec2 position() const { return evaluator_.maps()[state_.elem].position(state_.xi); }

  // True when the line has ended.
  bool advance_by_a_step() {
    StreamStep step;
    StreamState end;
    accepted_step(step, end);
    const ElementExit exit = first_exit(step);
    if (exit.edge < 0) {
      push(step);
      state_ = end;
    } else {
      if (leave_element(step, exit)) return true;
      if (closes_lap(evaluator_, state_, s_, options_.hit_distance, 3 * step.elem + exit.edge, line_)) {
        line_.is_limit_cycle = true;
        finish(Streamline::End::length, position());
        return true;
      }
    }
    return ends_at_node(position());
  }

  void accepted_step(StreamStep& step, StreamState& end) {
    h_ = std::min({h_, options_.max_step, length_to_exit(state_, options_.max_step), proximity_.longest_step()});
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
      if (h_ < 1e-7 * options_.tolerance || h_ < 1e-15 * s_) fail_without_direction(evaluator_, line_, position());
    }
  }

  void push(const StreamStep& step) {
    if (step.length > 0) line_.steps.push_back(step);
    s_ += step.length;
  }

  // Continues in the neighbour; true if the line ends on the boundary.
  bool leave_element(StreamStep& step, const ElementExit& exit) {
    step.length = exit.fraction * step.h;
    push(step);
    if (!state_.is_straight) state_.angle = direction_of(evaluator_, step, exit.fraction, state_.angle);
    const mesh::TriTopology& topology = evaluator_.topology();
    const int neighbor = topology.elem2neighbors[step.elem][exit.edge];
    if (neighbor < 0) {
      end_on_boundary(step, exit);
      return true;
    }
    const int edge = topology.elem2neighbor_edges[step.elem][exit.edge];
    const double along = fraction_along_edge(exit.edge, step.xi(exit.fraction));
    state_ =
        stream_state(evaluator_, neighbor, spectral::tri_edge_point(edge, 1 - along), state_.angle, state_.is_straight);
    return false;
  }

  void end_on_boundary(const StreamStep& step, const ElementExit& exit) {
    const ExitPoint foot = boundary_foot(evaluator_, step, exit);
    state_.angle = stream_state(evaluator_, step.elem, step.xi(exit.fraction), state_.angle, state_.is_straight).angle;
    if (ends_at_node(foot.position)) return;
    line_.reached = {-1, foot.curve, foot.t};
    finish(Streamline::End::boundary, foot.position);
  }

  bool ends_at_node(Vec2 x) {
    const int node = proximity_.node_hit_at(x, options_.hit_distance);
    if (node < 0) return false;
    line_.reached = {node, -1, 0};
    finish(Streamline::End::node, nodes_.points()[node]);
    return true;
  }

  void finish(Streamline::End how, Vec2 where) {
    line_.end = how;
    line_.end_position = where;
    line_.end_angle = state_.angle;
    line_.front.state = state_;
    line_.front.next_step = h_;
    line_.index_steps();
  }

  const field::FieldEvaluator& evaluator_;
  const PointGrid& nodes_;
  const AdvanceOptions& options_;
  Streamline& line_;
  NodeProximity proximity_;
  StreamState state_;
  double s_, h_;  // arc length, and the next step
};

}  // namespace

NodeProximity::NodeProximity(const PointGrid& nodes, Vec2 origin, bool is_at_origin)
    : nodes_(nodes), origin_(origin), is_at_origin_(is_at_origin) {
  const int nearest = nodes.nearest(origin, [](int) { return true; }).point;
  if (nearest >= 0 && nodes.points()[nearest] == origin) own_ = nearest;
}

int NodeProximity::move_to(Vec2 x) {
  const PointGrid::Nearest other = nodes_.nearest(x, [this](int n) { return nodes_.points()[n] != origin_; });
  longest_step_ = std::sqrt(other.distance2) / 2;
  if (own_ < 0 || is_at_origin_) return other.point;
  const double own_distance2 = norm2(x - nodes_.points()[own_]);
  const bool is_own_nearer =
      own_distance2 < other.distance2 || (own_distance2 == other.distance2 && own_ < other.point);
  return is_own_nearer ? own_ : other.point;
}

int NodeProximity::node_hit_at(Vec2 x, double hit_distance) {
  if (distance(x, origin_) > 10 * hit_distance) is_at_origin_ = false;
  const int node = move_to(x);
  return node >= 0 && distance(x, nodes_.points()[node]) <= hit_distance ? node : -1;
}

Streamline advance(const field::FieldEvaluator& evaluator, const Launch& launch, const PointGrid& nodes,
                   const AdvanceOptions& options) {
  Streamline line;
  line.launch = launch;
  line.front.state = stream_state(evaluator, launch.elem, launch.xi, launch.angle_there, launch.is_straight);
  line.front.next_step = std::max(launch.radius, 1e-3 * options.max_step);
  StreamlineIntegrator(evaluator, nodes, options, line).run();
  return line;
}

void follow(const field::FieldEvaluator& evaluator, Streamline& line, const PointGrid& nodes,
            const AdvanceOptions& options) {
  if (line.is_endless() && !line.is_limit_cycle) StreamlineIntegrator(evaluator, nodes, options, line).run();
}

}  // namespace quadrille::trace
