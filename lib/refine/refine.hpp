#pragma once
// From blocks to the final mesh: one count and one spacing per chord, elements sampled from the exact block maps.

#include <optional>
#include <vector>

#include "base/report.hpp"
#include "layers/wall_spec.hpp"
#include "model/block_layout.hpp"
#include "model/quad_mesh.hpp"
#include "sizing/grade_chords.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::refine {

/// What an element of that order can be asked for without many more of them than its size wants, in diameters: 5e-3,
/// 5e-4, 2e-5 at orders 1, 2, 3, then 5e-7.
double default_geometry_tol(int order);

struct RefineOptions {
  double size = 0;             ///< wanted edge length in file units; 0: diameter / 20
  int order = 4;               ///< shape order N, 1..20
  double geometry_tol = 0;     ///< greatest distance of mesh boundary and CAD curve, in diameters; 0: by the order
  bool allow_invalid = false;  ///< give the mesh, marked as not valid, also where elements are not proved
  std::optional<sizing::SizeField> size_field =
      {};  ///< wanted edge lengths, in place of `size` (sizing/make_size_field)
  sizing::SizeRule size_rule = sizing::SizeRule::nearest;
  std::vector<sizing::ChordCount> counts = {};  ///< for single chords, in place of their sizes
  std::vector<layers::WallSpec> walls = {};     ///< layers along boundaries (layers/wall_layers)
  std::vector<int> blocks = {};  ///< chords through these only are refined (refine/chosen_blocks); empty: all
  int relax = 0;                 ///< sweeps of relaxation (refine/relax)
  void validate() const;         ///< throws UsageError
};

/// Lines across chords are aligned (refine/align_chords); where that leaves an invalid element and equal arc-length
/// fractions do not, these are taken. Throws ComputeError with the place of the worst element when one cannot be proved
/// valid (unless allow_invalid), and when the mesh would be beyond all measure.
QuadMesh refine(const BlockLayout& layout, const RefineOptions& options, Report& report);

}  // namespace quadrille::refine
