#include "refine/joint_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/tolerance.hpp"

namespace quadrille::refine {
namespace {

using Joints = std::vector<LoopJoint>;

/// The free vertex on the boundary that is nearest to a joint, of equally near ones the one that began there; or the
/// fixed one that is there. -1: none.
int nearest_vertex(const LoopJoint& joint, const RelaxProblem& problem, const VertexMoves& moves,
                   const std::vector<int>& taken) {
  const double total = problem.boundary.loop_length(joint.loop);
  const double same = tolerance::round_off * problem.start.face.diameter;
  const std::vector<SlidingVertex>& vertices = problem.boundary.vertices();
  int nearest = -1;
  double least = total;
  for (int b = 0; b < static_cast<int>(vertices.size()); ++b) {
    const int v = problem.follow.vertex_of(b);
    if (vertices[b].loop != joint.loop || std::ranges::count(taken, b) > 0) continue;
    const double began = std::remainder(joint.length - vertices[b].length, total);
    const double slide = std::abs(std::remainder(joint.length - vertices[b].length - moves[v].x, total));
    if (problem.is_fixed[v] && slide > same) continue;
    const double length = slide - (std::abs(began) < same ? same : 0);
    if (length < least) least = length, nearest = b;
  }
  return nearest;
}

/// The slides that put the vertices of a loop at its joints, each in its turn around the loop, with the least squares.
std::vector<double> slides_to(const Joints& joints, const std::vector<double>& lengths, double total) {
  std::vector<double> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t turn = 0; turn < joints.size(); ++turn) {
    std::vector<double> slides;
    for (std::size_t k = 0; k < lengths.size(); ++k)
      slides.push_back(std::remainder(joints[(k + turn) % joints.size()].length - lengths[k], total));
    const double squares = std::inner_product(slides.begin(), slides.end(), slides.begin(), 0.0);
    if (squares < least) least = squares, best = std::move(slides);
  }
  return best;
}

/// Adds those of the joints of one loop. Returns whether there are enough.
bool add_loop(const RelaxProblem& problem, const VertexMoves& moves, const Joints& joints,
              std::vector<JointVertex>& found) {
  std::vector<int> chosen;
  for (const LoopJoint& joint : joints) chosen.push_back(nearest_vertex(joint, problem, moves, chosen));
  if (std::ranges::count(chosen, -1) > 0) return false;
  const double total = problem.boundary.loop_length(joints[0].loop);
  const auto length = [&](int b) {
    const double x = problem.boundary.vertices()[b].length + moves[problem.follow.vertex_of(b)].x;
    return x - total * std::floor(x / total);
  };
  std::ranges::sort(chosen, {}, length);
  std::vector<double> lengths;
  for (const int b : chosen) lengths.push_back(length(b));
  const std::vector<double> slides = slides_to(joints, lengths, total);
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (const int v = problem.follow.vertex_of(chosen[k]); !problem.is_fixed[v]) found.push_back({v, slides[k]});
  return true;
}

}  // namespace

std::optional<std::vector<JointVertex>> vertices_at_joints(const RelaxProblem& problem, const VertexMoves& moves) {
  const Joints& joints = problem.boundary.free_joints();
  std::vector<JointVertex> found;
  for (auto first = joints.begin(); first != joints.end();) {
    const auto last = std::find_if(first, joints.end(), [&](const LoopJoint& j) { return j.loop != first->loop; });
    if (!add_loop(problem, moves, {first, last}, found)) return std::nullopt;
    first = last;
  }
  return found;
}

}  // namespace quadrille::refine
