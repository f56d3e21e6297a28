#pragma once
// The one option that helps a mesh that is not good most (mesh/verdict). On some 25 faces whose meshes were not good,
// a smaller size lowered the resolution ratio most often and most; other nodes, layouts and counts of chords did so now
// and then, and nothing in the mesh told when.
//
// A high resolution ratio mostly comes from blocks that are narrower than the elements are long: shorter elements
// lengthwise are nearer to squares. The ratio at half the size, a third and so on is expected from the mesh that there
// is (mesh/finer_elements); the greatest size at which it is good, or at most a fifth, is the advice. Nothing is
// advised for scaled Jacobians, all of which were due to corners of the face where they were low, nor for area jumps:
// more elements along short curves (--per-curve 2) lowered them on 4 of 4 faces, but raised the resolution ratio to 20
// and 90 on two.

#include <optional>
#include <string>

#include "mesh/verdict.hpp"
#include "sizing/make_size_field.hpp"

namespace quadrille::sizing {

struct Advice {
  std::string option;   ///< "--size 0.5", for a lower resolution ratio
  long long quads = 0;  ///< that are expected with it, about
};

/// If the resolution ratio is a fault. `prescribed`: as the user prescribes sizes; `applied`: the same
/// after with_curve_sizes, by which the mesh was made, on its face. Elements must have prescribed lengths.
std::optional<Advice> advice_for(const QuadMesh& mesh, const mesh::Verdict& verdict, const SizeOptions& prescribed,
                                 const SizeOptions& applied);

/// "; give --size 0.5 (about 560 quads) for a lower resolution ratio".
std::string describe(const Advice& advice);

}  // namespace quadrille::sizing
