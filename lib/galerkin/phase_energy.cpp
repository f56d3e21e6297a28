#include "galerkin/phase_energy.hpp"

#include <memory>

namespace quadrille::galerkin {

std::function<PhaseEnergy(const PhaseNodes&)> phase_energy_function(const Field& field, const PhaseOptions& options,
                                                                    int num_threads) {
  struct Kept {
    TriMesh mesh;
    PhaseSolver solver;
    Kept(const Field& f, int threads) : mesh(f.mesh), solver(mesh, f.elem_order, threads) {}
  };
  return [kept = std::make_shared<Kept>(field, num_threads), options](const PhaseNodes& asked) {
    return kept->solver.energy(asked, options);
  };
}

}  // namespace quadrille::galerkin
