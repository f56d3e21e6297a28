#include "refine/relax_problem.hpp"

namespace quadrille::refine {

RelaxProblem::RelaxProblem(const QuadMesh& mesh, const std::vector<bool>& frozen_elems)
    : start(mesh), boundary(start), follow(start, boundary), energy(start), is_fixed(follow.num_vertices(), false) {
  for (int v = 0; v < num_vertices(); ++v)
    if (const int b = follow.on_boundary(v); b >= 0) is_fixed[v] = boundary.vertices()[b].is_fixed;
  for (std::size_t elem = 0; elem < frozen_elems.size(); ++elem)
    if (frozen_elems[elem])
      for (const int v : follow.elem_vertices()[elem]) is_fixed[v] = true;
}

double RelaxProblem::total_energy(const std::vector<Vec2>& nodes) const {
  double sum = 0;
  for (int elem = 0; elem < start.num_elems(); ++elem) sum += energy.value(elem, nodes);
  return sum;
}

}  // namespace quadrille::refine
