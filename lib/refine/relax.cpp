#include "refine/relax.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "refine/boundary_slide.hpp"
#include "refine/node_follow.hpp"
#include "refine/shape_energy.hpp"
#include "refine/validity.hpp"
#include "spectral/quad_map.hpp"

namespace quadrille::refine {
namespace {

/// Within this, scaled Jacobians and errors in tolerances are equal: mirror images are treated alike.
constexpr double same_quality = 1e-6;
constexpr double rounding = 1e-12;
constexpr double least_progress = 1e-7;  ///< share of the energy above its least; less in a sweep ends the relaxation
constexpr int max_halvings = 6;
constexpr int max_returns = 12;
/// A vertex moves by this share of the shortest edge at it at most, in one sweep.
constexpr double longest_step = 0.25;

using Symmetric = std::array<double, 3>;  ///< xx, xy, yy

double dot_of(const VertexMoves& a, const VertexMoves& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

Vec2 solve(const Symmetric& h, Vec2 g) {
  const double det = h[0] * h[2] - h[1] * h[1];
  return det > 0 ? Vec2{h[2] * g.x - h[1] * g.y, h[0] * g.y - h[1] * g.x} / det : Vec2{};
}

/// Values below 0 are bad. Where one is so by hardly anything, its equals on the other side are taken as bad as well.
double limit_for_equals(const std::vector<double>& values) {
  const bool is_tie = std::any_of(values.begin(), values.end(), [](double x) { return x < 0 && x > -same_quality; });
  return is_tie ? same_quality : 0;
}

class Relaxation {
 public:
  Relaxation(QuadMesh& mesh, const RelaxOptions& options)
      : mesh_(mesh),
        options_(options),
        start_(mesh),
        boundary_(start_),
        follow_(start_, boundary_),
        energy_(start_),
        moves_(follow_.num_vertices()),
        is_fixed_(follow_.num_vertices(), false) {
    for (int v = 0; v < follow_.num_vertices(); ++v)
      if (const int b = follow_.on_boundary(v); b >= 0) is_fixed_[v] = boundary_.vertices()[b].is_fixed;
    for (std::size_t elem = 0; elem < options.frozen_elems.size(); ++elem)
      if (options.frozen_elems[elem])
        for (const int v : follow_.elem_vertices()[elem]) is_fixed_[v] = true;
  }

  RelaxOutcome run() {
    RelaxOutcome outcome;
    value_ = outcome.energy_before = total_energy(mesh_.nodes);
    for (int sweep = 0; sweep < options_.sweeps; ++sweep) {
      const double before = value_;
      if (!step()) break;
      ++outcome.sweeps;
      if (before - value_ < least_progress * (before - mesh_.num_elems())) break;
    }
    const double per_elem = 1.0 / mesh_.num_elems();
    outcome.energy_before *= per_elem;
    outcome.energy_after = value_ * per_elem;
    for (int v = 0; v < follow_.num_vertices(); ++v)
      outcome.largest_move = std::max(outcome.largest_move, norm(moves_[v]));
    return outcome;
  }

 private:
  double total_energy(const std::vector<Vec2>& nodes) const {
    double sum = 0;
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) sum += energy_.value(elem, nodes);
    return sum;
  }

  /// Along the curve where a vertex is on the boundary.
  Vec2 reduced(int vertex, Vec2 gradient, Symmetric& hessian) const {
    const int b = follow_.on_boundary(vertex);
    if (b < 0) return gradient;
    const Vec2 t = boundary_.at(b, moves_[vertex].x).tangent;
    hessian = {hessian[0] * t.x * t.x + 2 * hessian[1] * t.x * t.y + hessian[2] * t.y * t.y, 0, 1};
    return {dot(gradient, t), 0};
  }

  /// Direction of steepest descent in the metric of the Hessian's diagonal blocks, made conjugate to the last one.
  VertexMoves direction() {
    VertexMoves gradient(moves_.size());
    std::vector<Symmetric> hessian(moves_.size(), Symmetric{});
    std::vector<double> room(moves_.size(), std::numeric_limits<double>::infinity());
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      const ElementEnergy e = energy_.with_derivatives(elem, mesh_.nodes);
      for (int c = 0; c < 4; ++c) {
        const int v = follow_.elem_vertices()[elem][c];
        gradient[v] += e.gradient[c];
        for (int k = 0; k < 3; ++k) hessian[v][k] += e.hessian[c][k];
      }
      limit_by_edges(elem, room);
    }
    VertexMoves descent(moves_.size());
    for (std::size_t v = 0; v < moves_.size(); ++v) {
      if (is_fixed_[v]) gradient[v] = {};
      gradient[v] = reduced(static_cast<int>(v), gradient[v], hessian[v]);
      descent[v] = -solve(hessian[v], gradient[v]);
    }
    const double slope = dot_of(gradient, descent);
    double beta = 0;
    if (last_slope_ < 0) {
      VertexMoves change = gradient;
      for (std::size_t v = 0; v < change.size(); ++v) change[v] -= last_gradient_[v];
      beta = std::max(0.0, dot_of(change, descent) / last_slope_);  // Polak-Ribiere
    }
    VertexMoves p = descent;
    if (beta > 0)
      for (std::size_t v = 0; v < p.size(); ++v) p[v] += beta * last_direction_[v];
    if (dot_of(p, gradient) >= 0) p = descent;
    last_gradient_ = std::move(gradient);
    last_slope_ = slope;
    last_direction_ = p;
    for (std::size_t v = 0; v < p.size(); ++v)
      if (const double length = norm(p[v]); length > longest_step * room[v]) p[v] *= longest_step * room[v] / length;
    return p;
  }

  void limit_by_edges(int elem, std::vector<double>& room) const {
    const int n = mesh_.order, width = n + 1;
    const int* nodes = &mesh_.elem_nodes[elem * width * width];
    const std::array<int, 4> corner{nodes[0], nodes[n], nodes[width * width - 1], nodes[width * n]};
    const auto& vertices = follow_.elem_vertices()[elem];
    for (int c = 0; c < 4; ++c) {
      const double length = distance(mesh_.nodes[corner[c]], mesh_.nodes[corner[(c + 1) % 4]]);
      for (const int v : {vertices[c], vertices[(c + 1) % 4]}) room[v] = std::min(room[v], length);
    }
  }

  /// One sweep; false when nothing could be moved.
  bool step() {
    const VertexMoves p = direction();
    double length = first_length_;
    for (int halving = 0; halving < max_halvings; ++halving, length /= 2) {
      VertexMoves trial = moves_;
      for (std::size_t v = 0; v < trial.size(); ++v) trial[v] += length * p[v];
      if (!accept(std::move(trial))) continue;
      first_length_ = std::min(halving == 0 ? 2 * length : length, 8.0);
      return true;
    }
    return false;
  }

  /// Takes the moves back where elements would be too bad, and keeps the rest when the energy falls.
  bool accept(VertexMoves trial) {
    QuadMesh moved = mesh_;
    for (int round = 0; round < max_returns; ++round) {
      moved.nodes = follow_.nodes(trial);
      const double value = total_energy(moved.nodes);
      if (!(value < value_)) return false;
      if (take_back(trial, moved)) continue;
      mesh_ = std::move(moved);
      moves_ = std::move(trial);
      value_ = value;
      return true;
    }
    return false;
  }

  /// Measures what has moved; vertices of elements and edges that must not be so go back. False when there are none.
  bool take_back(VertexMoves& trial, QuadMesh& moved) const {
    std::vector<bool> is_bad(trial.size(), false);
    const auto mark = [&](int v) { is_bad[v] = true; };
    for (const int elem : bad_elems(trial, moved))
      std::for_each(follow_.elem_vertices()[elem].begin(), follow_.elem_vertices()[elem].end(), mark);
    for (const int e : bad_edges(trial)) mark(end_vertices(e)[0]), mark(end_vertices(e)[1]);
    bool is_any = false;
    for (std::size_t v = 0; v < trial.size(); ++v)
      if (is_bad[v] && trial[v] != moves_[v]) trial[v] = moves_[v], is_any = true;
    return is_any;
  }

  bool has_moved(const VertexMoves& trial, int v) const { return trial[v] != moves_[v]; }

  std::vector<int> bad_elems(const VertexMoves& trial, QuadMesh& moved) const {
    std::vector<int> elems, bad;
    for (int elem = 0; elem < moved.num_elems(); ++elem) {
      const auto& vertices = follow_.elem_vertices()[elem];
      const bool is_moved = std::any_of(vertices.begin(), vertices.end(), [&](int v) { return has_moved(trial, v); });
      const std::vector<Vec2> nodes = is_moved ? element_nodes(moved, elem) : std::vector<Vec2>{};
      moved.elem_scaled_jacobian[elem] =
          is_moved ? spectral::quad_scaled_jacobian(moved.order, nodes.data()) : mesh_.elem_scaled_jacobian[elem];
      moved.elem_jacobian_bound[elem] =
          is_moved ? spectral::quad_jacobian_lower_bound(moved.order, nodes.data()) : mesh_.elem_jacobian_bound[elem];
      if (is_moved) elems.push_back(elem);
    }
    const double floor = *std::min_element(mesh_.elem_scaled_jacobian.begin(), mesh_.elem_scaled_jacobian.end());
    std::vector<double> above;
    for (const int elem : elems) above.push_back(moved.elem_scaled_jacobian[elem] - floor + rounding);
    const double limit = limit_for_equals(above);
    for (std::size_t i = 0; i < elems.size(); ++i)
      if (above[i] < limit || !(moved.elem_jacobian_bound[elems[i]] > 0)) bad.push_back(elems[i]);
    return bad;
  }

  std::array<int, 2> end_vertices(int edge) const {
    const SlidingEdge& e = boundary_.edges()[edge];
    return {follow_.vertex_of(e.from), follow_.vertex_of(e.to)};
  }

  std::vector<int> bad_edges(const VertexMoves& trial) const {
    std::vector<int> edges, bad;
    std::vector<double> room;
    for (int e = 0; e < static_cast<int>(boundary_.edges().size()); ++e) {
      const auto [from, to] = end_vertices(e);
      if (!has_moved(trial, from) && !has_moved(trial, to)) continue;
      edges.push_back(e);
      room.push_back(1 - boundary_.edge_error(e, trial[from].x, trial[to].x) / options_.tolerance);
    }
    const double limit = limit_for_equals(room);
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (room[i] < limit) bad.push_back(edges[i]);
    return bad;
  }

  QuadMesh& mesh_;
  const RelaxOptions& options_;
  const QuadMesh start_;
  const BoundarySlide boundary_;
  const NodeFollow follow_;
  const ShapeEnergy energy_;
  VertexMoves moves_, last_gradient_, last_direction_;
  std::vector<bool> is_fixed_;
  double value_ = 0, last_slope_ = 0, first_length_ = 1;
};

}  // namespace

RelaxOutcome relax(QuadMesh& mesh, const RelaxOptions& options) {
  if (options.sweeps == 0 || !mesh.is_valid) return {};
  const RelaxOutcome outcome = Relaxation(mesh, options).run();
  measure_elements(mesh);
  return outcome;
}

}  // namespace quadrille::refine
