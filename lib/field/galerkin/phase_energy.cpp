#include "galerkin/phase_energy.hpp"

#include <utility>

namespace quadrille::galerkin {

std::function<PhaseEnergy(const PhaseNodes&)> phase_energy_function(std::shared_ptr<PhaseSolver> solver,
                                                                    const PhaseOptions& options) {
  return [solver = std::move(solver), options](const PhaseNodes& asked) { return solver->energy(asked, options); };
}

}  // namespace quadrille::galerkin
