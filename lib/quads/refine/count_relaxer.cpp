#include "refine/count_relaxer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerance.hpp"
#include "refine/even_vertices.hpp"

namespace quadrille::refine {
namespace {

SizeRelaxation coarsely(SizeRelaxation options) {
  options.least_progress = coarse_progress;
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

/// The elements with straight sides; vertices are nodes.
QuadMesh straight(const RelaxProblem& problem, const QuadMesh& mesh) {
  QuadMesh result = mesh;
  result.order = 1;
  result.elem_nodes.clear();
  for (const auto& [a, b, c, d] : problem.follow.elem_vertices())
    for (const int vertex : {a, b, d, c}) result.elem_nodes.push_back(vertex);
  return result;
}

}  // namespace

CountRelaxer::CountRelaxer(const QuadMesh& mesh, SizeRelaxation options)
    : options_(coarsely(std::move(options))),
      problem_(mesh, options_.frozen_elems, options_.slides_off),
      relaxer_(problem_, mesh, options_),
      kept_(relaxer_.moves),
      mesh_(straight(problem_, mesh)) {
  fix_at_joints(problem_);
  for (const int vertex : vertices_on(problem_, options_.even_curves)) problem_.fix_vertex(vertex);
}

const QuadMesh& CountRelaxer::moved(std::vector<Vec2> counts) {
  relaxer_.moves = kept_;
  relaxer_.set_counts(std::move(counts));
  relaxer_.run();
  mesh_.nodes = relaxer_.energy.positions(relaxer_.moves);
  for (int elem = 0; elem < mesh_.num_elems(); ++elem) mesh_.elem_scaled_jacobian[elem] = corner_jacobian(mesh_, elem);
  return mesh_;
}

mesh::Resolution CountRelaxer::resolution(const sizing::SizeField& sizes, const std::vector<Vec2>& greatest_lengths) {
  std::vector<double> lengths;
  for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
    double& length = mesh_.elem_prescribed_length[elem];
    if (length > 0) length = sizes.at(mesh::centre(mesh_, elem), mesh_.region_of(elem));
    lengths.push_back(length);
  }
  return mesh::resolution(mesh_, greatest_lengths, relaxer_.energy.powers(lengths));
}

}  // namespace quadrille::refine
