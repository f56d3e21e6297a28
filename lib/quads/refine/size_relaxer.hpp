#pragma once
// The iteration of relaxation to the prescribed sizes (refine/relax_sizes): a limited-memory quasi-Newton method
// (Nocedal 1980) from the Hessian's diagonal blocks. Where it does not end within a few dozens of sweeps, or hardly
// advances far from the least energy, because some elements are much thinner than others, Newton's method while the
// energy falls much, then the quasi-Newton method from the last Hessian. Directions are averaged over the symmetries of
// the face.

#include <optional>
#include <vector>

#include "refine/inner_edges.hpp"
#include "refine/inverse_hessian.hpp"
#include "refine/joint_vertices.hpp"
#include "refine/placed_vertices.hpp"
#include "refine/refine_options.hpp"
#include "refine/size_energy.hpp"
#include "refine/vertex_symmetry.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::refine {

struct SizeRelaxation {
  const sizing::SizeField& sizes;
  InnerEdges inner_edges = InnerEdges::straight;
  double tolerance = 0;                      ///< greatest distance between mesh boundary and CAD curve, a length, > 0
  int sweeps = 200;                          ///< greatest number
  std::vector<bool> frozen_elems = {};       ///< elements that keep all nodes; empty: none
  std::vector<bool> kept_elems = {};         ///< elements whose edges inside keep their curves
  SlidesOff slides_off = SlidesOff::joints;  ///< what vertices on the boundary may
  /// By element: limits of the sizes along s and t (sizing/hole_rings); empty: none.
  std::vector<Vec2> greatest_lengths = {};
  /// Elements are to be as long and wide as they are, whatever the sizes, and none becomes worse than the worst one is.
  bool keeps_lengths = false;
  /// Elements, each as often as it is moved: some seconds. Where that is not enough to keep the tolerance, no
  /// vertex is moved.
  double most_work = 1e7;
  const PlacedVertices* start = nullptr;  ///< where vertices begin, if that is possible; null: as they are
  double least_progress =
      fine_progress;  ///< relaxation ends after sweeps in turn that lower the energy by a lesser part
  PrescribedDirections directions = {};  ///< of the sides of elements; empty: none
  std::vector<bool> even_curves = {};    ///< by curve: its vertices are at equal lengths (refine/even_vertices)
};

/// Moves vertices to the least energy.
class SizeRelaxer {
 public:
  /// `problem` and `options` must outlive it; `shaped`: the mesh with its edges inside shaped.
  SizeRelaxer(const RelaxProblem& problem, const QuadMesh& shaped, const SizeRelaxation& options);
  /// Vertices begin there, if the energy is finite.
  void begin_at(const PlacedVertices& start);
  /// Relaxes until the energy hardly falls.
  void run();
  /// Puts vertices where they are to be held (refine/joint_vertices, refine/even_vertices), and fixes them. Returns
  /// whether that is possible; not without a value.
  bool hold(const std::optional<std::vector<HeldVertex>>& vertices, RelaxProblem& problem);
  /// With the vertices that are fixed by now where they are held; if that is not possible, with all. Returns whether
  /// either is possible.
  bool begin_again();
  /// What each element stands for: that many elements along s and t.
  void set_counts(std::vector<Vec2> counts);
  /// Factor of the size of an element along a side, at first 1.
  double& shorter(int elem, int side) { return side % 2 == 0 ? shorter_[elem].x : shorter_[elem].y; }

  /// Whether the work of all runs is SizeRelaxation::most_work: no run goes on.
  bool is_exhausted() const { return work_ > options_.most_work; }

  SizeEnergy energy;
  VertexMoves moves;
  double least_progress;  ///< of the next runs; at first that of the options
  double value = 0;
  int num_sweeps = 0;

 private:
  /// Of an element, where its middle or corner was then.
  struct KnownSize {
    Vec2 at;
    int region = -1;
    sizing::DirectedSize size = {};
  };

  void set_sizes();
  const sizing::DirectedSize& prescribed_size(int elem, Vec2 at, KnownSize& known);
  Vec2 log_size_gradient(int elem, Vec2 middle);
  void set_directions();
  EnergyDerivatives begin(bool is_first);
  double longest_step(const VertexMoves& direction) const;
  bool step(EnergyDerivatives& at);
  double steps_of_factors() const;  ///< that take as long
  void count_work(double steps);

  const RelaxProblem& problem_;
  const SizeRelaxation& options_;
  VertexMoves held_;           ///< the moves of vertices that are fixed
  std::vector<Vec2> lengths_;  ///< by element, along s and t: the greatest that are prescribed; empty: no limits
  std::vector<double> size_;   ///< by element: the least
  std::vector<Vec2> shorter_;  ///< by element: factors of the size along s and t
  std::vector<Vec2> counts_;   ///< by element: of those along s and t for which it stands
  std::vector<KnownSize> known_sizes_, known_sizes_at_vertices_;  ///< by element, by vertex: the last ones
  std::optional<VertexSymmetry> symmetry_;
  InverseHessian inverse_;
  double work_ = 0;  ///< elements, each as often as it was moved
};

}  // namespace quadrille::refine
