#include "refine/count_relaxer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.hpp"

namespace quadrille::refine {
namespace {

constexpr double least_progress = 1e-3;  ///< of the energy: R is then true to about 1 %

SizeRelaxation coarsely(SizeRelaxation options) {
  options.least_progress = least_progress;
  return options;
}

void fix_at_joints(RelaxProblem& problem) {
  const double same = tolerance::round_off * problem.start.face.diameter;
  const BoundarySlide& boundary = problem.boundary;
  for (const LoopJoint& joint : boundary.free_joints())
    for (int b = 0; b < std::ssize(boundary.vertices()); ++b) {
      const SlidingVertex& v = boundary.vertices()[b];
      if (v.loop == joint.loop &&
          std::abs(std::remainder(v.length - joint.length, boundary.loop_length(v.loop))) < same)
        problem.fix_vertex(problem.follow.vertex_of(b));
    }
}

/// The least sine at the corners.
double corner_jacobian(const QuadMesh& mesh, int elem) {
  const auto corner = [&](int c) { return mesh.nodes[side_start(mesh, elem, c % 4)]; };
  double least = 1;
  for (int c = 0; c < 4; ++c) {
    const Vec2 out = corner(c + 1) - corner(c), in = corner(c + 3) - corner(c);
    least = std::min(least, cross(out, in) / (norm(out) * norm(in)));
  }
  return least;
}

}  // namespace

CountRelaxer::CountRelaxer(const QuadMesh& mesh, SizeRelaxation options)
    : options_(coarsely(std::move(options))),
      problem_(mesh, options_.frozen_elems, options_.slides_off),
      relaxer_(problem_, mesh, options_),
      kept_(relaxer_.moves),
      mesh_(mesh) {
  fix_at_joints(problem_);
}

const QuadMesh& CountRelaxer::moved(std::vector<Vec2> counts) {
  relaxer_.moves = kept_;
  relaxer_.set_counts(std::move(counts));
  relaxer_.run();
  mesh_.nodes = problem_.follow.nodes(relaxer_.moves);
  for (int elem = 0; elem < mesh_.num_elems(); ++elem) mesh_.elem_scaled_jacobian[elem] = corner_jacobian(mesh_, elem);
  return mesh_;
}

}  // namespace quadrille::refine
