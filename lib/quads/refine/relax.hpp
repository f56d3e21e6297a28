#pragma once
// Relaxation: moves the vertices of a valid mesh so that elements have better shapes; all other nodes follow.
//
// A sweep is a step of preconditioned conjugate gradients for the shape energy (refine/shape_energy) in all vertices at
// once, so that symmetric meshes stay symmetric, independent of their numbering: inner vertices move freely, also on
// sides of blocks, those on the boundary slide along it (refine/boundary_slide). Nodes on inner edges follow the ends
// linearly, those on the boundary are placed on the curves again, inner ones are shifted by the transfinite blend of
// their element's sides. A vertex moves back if an element would have a smaller scaled Jacobian than the worst of the
// mesh has, or not be proved valid, or if the boundary would miss its tolerance: the least scaled Jacobian never falls.

#include <vector>

#include "base/progress.hpp"
#include "base/report.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::refine {

struct RelaxOptions {
  int sweeps = 0;                       ///< greatest number; fewer if no vertex moves any more
  double tolerance = 0;                 ///< greatest distance between mesh boundary and CAD curve, a length, > 0
  std::vector<bool> frozen_elems = {};  ///< elements that keep all nodes; empty: none
  Progress* progress = nullptr;
};

struct RelaxOutcome {
  int sweeps = 0;                              ///< number of sweeps that moved a vertex
  double energy_before = 0, energy_after = 0;  ///< means per element
  double largest_move = 0;                     ///< of a vertex, a length
};

/// `mesh` must be measured (refine/validity) and is so again afterwards. A mesh that is not valid is not changed.
RelaxOutcome relax(QuadMesh& mesh, const RelaxOptions& options);

/// The same, with the keys relax.* of the report.
void relax_and_report(QuadMesh& mesh, const RelaxOptions& options, Report& report);

}  // namespace quadrille::refine
