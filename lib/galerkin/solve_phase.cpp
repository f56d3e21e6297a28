#include "galerkin/solve_phase.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "field/phase_boundary.hpp"
#include "galerkin/continuous.hpp"
#include "galerkin/twists.hpp"
#include "spectral/modified_basis.hpp"

namespace quadrille {

namespace {

// s with m = 0 and the harmonic measures w_1, w_2, ... of the holes; column f of elem_coefs[e] in the modified basis.
struct Functions {
  std::vector<Eigen::MatrixXd> elem_coefs;
  int num_unknowns = 0;
  double residual = 0;
};

// The data of function f: 0 is s, the others are 1 on their hole.
double datum(const CadFace& face, const PhaseBoundary& boundary, int f, int curve, double t) {
  if (f == 0) return boundary.remainder(curve, t);
  return face.loop_of(curve) == f ? 1 : 0;
}

// Two functions a solve: that is what the discretisation takes.
Functions solve_functions(const MeshContext& context, const std::vector<int>& elem_order,
                          const PhaseBoundary& boundary) {
  const CadFace& face = context.mesh->face;
  const int num_functions = face.num_loops();
  Functions functions;
  for (const int order : elem_order)
    functions.elem_coefs.emplace_back(Eigen::MatrixXd::Zero((order + 1) * (order + 2) / 2, num_functions));
  for (int f = 0; f < num_functions; f += 2) {
    const bool has_second = f + 1 < num_functions;
    ContinuousGalerkin discretization(context, [&, f](int curve, double t) {
      return Vec2{datum(face, boundary, f, curve, t), has_second ? datum(face, boundary, f + 1, curve, t) : 0};
    });
    const Solution solution = discretization.solve(elem_order);
    for (std::size_t e = 0; e < elem_order.size(); ++e)
      functions.elem_coefs[e].middleCols(f, has_second ? 2 : 1) = solution.elem_coefs[e].leftCols(has_second ? 2 : 1);
    functions.num_unknowns = solution.num_unknowns;
    functions.residual = std::max(functions.residual, solution.residual);
  }
  return functions;
}

// The loop that each vertex lies on, -1 inside.
std::vector<int> vertex_loops(const TriMesh& mesh) {
  std::vector<int> vertex2loop(mesh.vertices.size(), -1);
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    const int loop = mesh.face.loop_of(edge.curve);
    for (const int end : {edge.edge, (edge.edge + 1) % 3}) vertex2loop[mesh.elem2vertices[edge.elem][end]] = loop;
  }
  return vertex2loop;
}

// Row f, column j: a(f, w_j), the sum of the reactions over hole j's boundary. The sum of the vertex modes on the hole
// has the boundary values of w_j, and any such function gives the same because f is discretely harmonic.
Eigen::MatrixXd reactions(const MeshContext& context, const std::vector<int>& elem_order, const Functions& functions) {
  const TriMesh& mesh = *context.mesh;
  const int num_holes = mesh.face.num_loops() - 1;
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(num_holes + 1, num_holes);
  if (num_holes == 0) return sums;
  const std::vector<int> vertex2loop = vertex_loops(mesh);
  StiffnessTable stiffness(context);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const auto& vertices = mesh.elem2vertices[e];
    if (vertex2loop[vertices[0]] < 1 && vertex2loop[vertices[1]] < 1 && vertex2loop[vertices[2]] < 1) continue;
    const Eigen::MatrixXd flux = stiffness(e, elem_order[e]).topRows(3) * functions.elem_coefs[e];
    for (int k = 0; k < 3; ++k) {
      const int loop = vertex2loop[vertices[k]];
      if (loop >= 1) sums.col(loop - 1) += flux.row(k).transpose();
    }
  }
  return sums;
}

// Point 6, from r_j and K_ij.
void choose_twists(const Eigen::MatrixXd& reaction, const std::vector<int>& offsets, PhaseSolution& solution) {
  const int num_holes = static_cast<int>(reaction.cols());
  if (num_holes == 0) return;
  const Eigen::VectorXd r = reaction.row(0).transpose();
  const Eigen::MatrixXd k = reaction.bottomRows(num_holes);
  const Eigen::VectorXd best = -k.ldlt().solve(r) / (2 * pi);
  if (!best.allFinite()) throw ComputeError("the twists of the holes are not finite: some element has a folded shape");
  solution.twists = nearest_twists(k, best);
  for (std::size_t j = 0; j < offsets.size(); ++j) solution.twists[j] += offsets[j];
  const Eigen::VectorXd m = Eigen::Map<const Eigen::VectorXi>(solution.twists.data(), num_holes).cast<double>();
  const Eigen::VectorXd periods = (r + 2 * pi * k * m) / 4;
  solution.best_twists.assign(best.begin(), best.end());
  solution.periods.assign(periods.begin(), periods.end());
  solution.twist_energy = 2 * pi * pi * (m - best).dot(k * (m - best));
}

void add_coefficients(const Functions& functions, PhaseSolution& solution) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(1 + static_cast<int>(solution.twists.size()));
  for (std::size_t j = 0; j < solution.twists.size(); ++j)
    weights[1 + static_cast<int>(j)] = 2 * pi * solution.twists[j];
  solution.coef_offsets.push_back(0);
  for (std::size_t e = 0; e < solution.elem_order.size(); ++e) {
    const Eigen::VectorXd coefs =
        modified_to_orthogonal(solution.elem_order[e]).transpose() * (functions.elem_coefs[e] * weights);
    solution.s.insert(solution.s.end(), coefs.begin(), coefs.end());
    solution.coef_offsets.push_back(static_cast<int>(solution.s.size()));
  }
}

}  // namespace

PhaseSolution solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked,
                          const PhaseOptions& options, Report& report) {
  const std::size_t num_holes = mesh.face.num_loops() - 1;
  if (!options.twist_offsets.empty() && options.twist_offsets.size() != num_holes)
    throw UsageError(fmt::format("{} twist offsets for {} holes", options.twist_offsets.size(), num_holes));
  if (static_cast<int>(elem_order.size()) != mesh.num_elems()) throw Defect("the order map does not fit the mesh");
  const PhaseBoundary boundary(mesh.face, asked);
  const MeshContext context(mesh);
  const Functions functions = solve_functions(context, elem_order, boundary);
  if (!std::isfinite(functions.residual))
    throw ComputeError("the solution is not finite: some element has a folded shape");

  PhaseSolution solution;
  solution.terms = boundary.terms();
  solution.elem_order = elem_order;
  solution.num_unknowns = functions.num_unknowns;
  solution.residual = functions.residual;
  choose_twists(reactions(context, elem_order, functions), options.twist_offsets, solution);
  add_coefficients(functions, solution);
  report.set("solve.num_unknowns", solution.num_unknowns);
  report.set("solve.residual", solution.residual);
  report.set("phase.num_nodes", solution.terms.nodes.size());
  report.set("phase.num_corner_angles", solution.terms.corner_angles.size());
  report.set("phase.twists", std::vector<double>(solution.twists.begin(), solution.twists.end()));
  report.set("phase.best_twists", solution.best_twists);
  report.set("phase.periods", solution.periods);
  report.set("phase.twist_energy", solution.twist_energy);
  return solution;
}

PhaseSolution solve_phase(const TriMesh& mesh, const std::vector<int>& elem_order, const PhaseNodes& asked,
                          Report& report) {
  return solve_phase(mesh, elem_order, asked, {}, report);
}

}  // namespace quadrille
