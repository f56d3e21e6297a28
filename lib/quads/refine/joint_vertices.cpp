#include "refine/joint_vertices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "base/warning_codes.hpp"
#include "surface/positions.hpp"

namespace quadrille::refine {
namespace {

constexpr double equal_share = 0.8;  ///< of the tolerance, that edges of one length use: lengths will differ
constexpr int max_first = 8;         ///< vertices that are tried for the first place of a loop
constexpr double infinity = std::numeric_limits<double>::infinity();

struct LoopVertex {
  double length = 0;  ///< along the loop
  int vertex = 0;
};

/// A place of a loop where a vertex must be: a joint, or where a vertex is fixed.
struct Place {
  double length = 0;
  int fixed = -1;     ///< the number of that vertex in the loop, -1: a joint
  int num_edges = 1;  ///< at least, up to the next place
};

/// What is chosen for the places of one loop, from given vertices in their order.
class LoopChoice {
 public:
  LoopChoice(std::vector<LoopVertex> vertices, std::vector<Place> places, double total)
      : vertices_(std::move(vertices)), places_(std::move(places)), total_(total) {}

  /// By place: a vertex's number, which may be more than one turn on. Empty: none.
  std::vector<int> best() const;
  /// From the vertex to the place.
  double slide(int place, int vertex) const { return std::remainder(places_[place].length - length(vertex), total_); }

 private:
  int num_vertices() const { return static_cast<int>(vertices_.size()); }
  double length(int vertex) const {
    const int turns = vertex / num_vertices();
    return vertices_[vertex % num_vertices()].length + turns * total_;
  }
  double cost(int place, int vertex, int first) const;
  std::vector<int> best_from(int first, double& least) const;

  std::vector<LoopVertex> vertices_;
  std::vector<Place> places_;
  double total_;
};

double LoopChoice::cost(int place, int vertex, int first) const {
  if (places_[place].fixed >= 0) return vertex % num_vertices() == places_[place].fixed ? 0 : infinity;
  const double start = length(first) + slide(0, first), onward = places_[place].length - places_[0].length;
  const double slide = start + onward - length(vertex);
  return slide * slide;
}

/// With that vertex at the first place; `least`: the sum of squares to fall below.
std::vector<int> LoopChoice::best_from(int first, double& least) const {
  const int count = num_vertices(), num_places = static_cast<int>(places_.size());
  // By place and vertex from the first on: the least sum up to there, and the vertex of the place before in it.
  std::vector<std::vector<double>> sum(num_places, std::vector<double>(count, infinity));
  std::vector<std::vector<int>> before(num_places, std::vector<int>(count, -1));
  sum[0][0] = cost(0, first, first);
  for (int place = 1; place < num_places; ++place) {
    int best = -1;
    for (int v = places_[place - 1].num_edges; v < count; ++v) {
      const int last = v - places_[place - 1].num_edges;
      if (best < 0 || sum[place - 1][last] < sum[place - 1][best]) best = last;
      sum[place][v] = sum[place - 1][best] + cost(place, first + v, first);
      before[place][v] = best;
    }
  }
  int last = -1;
  for (int v = 0; v <= count - places_.back().num_edges; ++v)
    if (v < count && sum.back()[v] < least) least = sum.back()[v], last = v;
  if (last < 0) return {};
  std::vector<int> chosen(num_places);
  for (int place = num_places - 1; place >= 0; last = before[place--][std::max(last, 0)]) chosen[place] = first + last;
  return chosen;
}

std::vector<int> LoopChoice::best() const {
  std::vector<int> firsts(vertices_.size());
  for (int v = 0; v < num_vertices(); ++v) firsts[v] = v;
  std::ranges::stable_sort(firsts, {}, [&](int v) { return std::abs(slide(0, v)); });
  if (places_[0].fixed >= 0) firsts = {places_[0].fixed};
  double least = infinity;
  std::vector<int> best;
  for (std::size_t k = 0; k < firsts.size() && k < max_first; ++k)
    if (std::vector<int> chosen = best_from(firsts[k], least); !chosen.empty()) best = std::move(chosen);
  return best;
}

/// The least number of equal edges between two lengths that keep well within the tolerance, at most `most`.
int edges_needed(const BoundarySlide& boundary, int loop, double from, double to, double tolerance, int most) {
  for (int count = 1; count < most; ++count) {
    double error = 0;
    for (int k = 0; k < count && error <= equal_share * tolerance; ++k)
      error = boundary.error_between(loop, from + (to - from) * k / count, from + (to - from) * (k + 1) / count);
    if (error <= equal_share * tolerance) return count;
  }
  return most;
}

class JointChoice {
 public:
  JointChoice(const RelaxProblem& problem, const VertexMoves& moves, double tolerance)
      : problem_(problem), moves_(moves), tolerance_(tolerance) {}

  /// Adds those of one loop. Returns whether there are any.
  bool add(int loop, std::vector<HeldVertex>& found) const;

 private:
  std::vector<LoopVertex> vertices(int loop) const;
  std::vector<Place> places(int loop, const std::vector<LoopVertex>& vertices) const;
  int vertices_before(int loop, double from, double to) const;

  const RelaxProblem& problem_;
  const VertexMoves& moves_;
  double tolerance_;
};

std::vector<LoopVertex> JointChoice::vertices(int loop) const {
  const double total = problem_.boundary.loop_length(loop);
  const std::vector<SlidingVertex>& all = problem_.boundary.vertices();
  std::vector<LoopVertex> found;
  for (int b = 0; b < static_cast<int>(all.size()); ++b) {
    if (all[b].loop != loop) continue;
    const int v = problem_.follow.vertex_of(b);
    const double length = all[b].length + problem_.follow.slide(b, moves_);
    found.push_back({length - total * std::floor(length / total), v});
  }
  std::ranges::stable_sort(found, {}, &LoopVertex::length);
  return found;
}

/// How many began in [from, to): enough for the tolerance.
int JointChoice::vertices_before(int loop, double from, double to) const {
  const double total = problem_.boundary.loop_length(loop), same = tolerance::round_off * problem_.start.face.diameter;
  const auto is_between = [&](const SlidingVertex& v) {
    const double onward = v.length - from + same;
    return v.loop == loop && onward - total * std::floor(onward / total) < to - from;
  };
  return static_cast<int>(std::ranges::count_if(problem_.boundary.vertices(), is_between));
}

std::vector<Place> JointChoice::places(int loop, const std::vector<LoopVertex>& vertices) const {
  const double total = problem_.boundary.loop_length(loop), same = tolerance::round_off * problem_.start.face.diameter;
  std::vector<Place> found;
  for (int v = 0; v < static_cast<int>(vertices.size()); ++v)
    if (problem_.is_fixed[vertices[v].vertex]) found.push_back({vertices[v].length, v});
  const std::vector<Place> fixed = found;
  for (const LoopJoint& joint : problem_.boundary.free_joints()) {
    const auto is_there = [&](const Place& p) {
      return std::abs(std::remainder(p.length - joint.length, total)) < same;
    };
    if (joint.loop == loop && std::ranges::none_of(fixed, is_there)) found.push_back({joint.length});
  }
  std::ranges::stable_sort(found, {}, &Place::length);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Place& next = found[(k + 1) % found.size()];
    if (found[k].fixed >= 0 && next.fixed >= 0) continue;
    const double to = next.length + (k + 1 < found.size() ? 0 : total);
    const int before = vertices_before(loop, found[k].length, to);
    found[k].num_edges = edges_needed(problem_.boundary, loop, found[k].length, to, tolerance_, std::max(1, before));
  }
  return found;
}

bool JointChoice::add(int loop, std::vector<HeldVertex>& found) const {
  const std::vector<LoopVertex> vertices = this->vertices(loop);
  const std::vector<Place> places = this->places(loop, vertices);
  if (std::ranges::all_of(places, [](const Place& p) { return p.fixed >= 0; })) return true;
  const LoopChoice choice(vertices, places, problem_.boundary.loop_length(loop));
  const std::vector<int> chosen = choice.best();
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (places[k].fixed < 0)
      found.push_back({vertices[chosen[k] % vertices.size()].vertex, choice.slide(static_cast<int>(k), chosen[k])});
  return !chosen.empty();
}

}  // namespace

std::optional<std::vector<HeldVertex>> vertices_at_joints(const RelaxProblem& problem, const VertexMoves& moves,
                                                          double tolerance) {
  const JointChoice choice(problem, moves, tolerance);
  std::vector<HeldVertex> found;
  int last = -1;
  for (const LoopJoint& joint : problem.boundary.free_joints())
    if (joint.loop != std::exchange(last, joint.loop) && !choice.add(joint.loop, found)) return std::nullopt;
  return found;
}

std::vector<int> joints_inside_edges(const QuadMesh& mesh) {
  const CadFace& face = mesh.face;
  std::vector<bool> has_vertex(face.curves.size(), false);
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges)
    if (distance(mesh.nodes[side_start(mesh, edge.elem, edge.side)], face.joints[edge.curve].position) <
        tolerance::round_off * face.diameter)
      has_vertex[edge.curve] = true;
  std::vector<int> joints;
  for (int c = 0; c < face.num_curves(); ++c)
    if (!has_vertex[c] && !face.is_interface(c) && face.curve_names[face.previous_in_loop(c)] != face.curve_names[c])
      joints.push_back(c);
  return joints;
}

void warn_of_joints(const QuadMesh& mesh, Report& report) {
  const std::vector<int> joints = joints_inside_edges(mesh);
  if (joints.empty()) return;
  const CadFace& face = mesh.face;
  const int curve = joints[0];
  report.warn(
      warning::joint_inside_edge,
      fmt::format("{} curves without given names begin inside an edge, which has the name of one curve, the first of "
                  "them {} after {} at {}: give them names (cad2tri --name) where other boundary conditions begin, or "
                  "lower --size",
                  joints.size(), face.curve_names[curve], face.curve_names[face.previous_in_loop(curve)],
                  surface::position_text(face, face.joints[curve].position)));
}

}  // namespace quadrille::refine
