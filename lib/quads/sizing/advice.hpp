#pragma once
// The one option that helps a mesh that is not good most (mesh/verdict). On some 25 faces whose meshes were not good,
// a smaller size lowered the resolution ratio most often and most; other nodes, layouts and counts of chords did so now
// and then, and nothing in the mesh told when.
//
// A high resolution ratio mostly comes from blocks that are narrower than the elements are long: shorter elements
// lengthwise are nearer to squares. The ratio at half the size, a third and so on is expected from the mesh that there
// is (mesh/finer_elements); the greatest size at which it is good, or at most a fifth, is the advice. An area jump
// comes from short curves for which elements along them are not short enough: then elements are prescribed for each.
// Nothing is advised for scaled Jacobians: on these faces all below the limit were due to corners of the face.

#include <optional>
#include <string>

#include "mesh/verdict.hpp"
#include "sizing/make_size_field.hpp"

namespace quadrille::sizing {

struct Advice {
  std::string option;                           ///< "--size 0.5"
  mesh::Limit limit = mesh::Limit::resolution;  ///< what it makes better
  long long quads = 0;                          ///< that are expected with it, about; 0: not known
};

/// For the most severe fault for which there is one. `prescribed`: as the user prescribes sizes; `applied`: the same
/// after with_curve_sizes, by which the mesh was made, on its face. Elements must have prescribed lengths.
std::optional<Advice> advice_for(const QuadMesh& mesh, const mesh::Verdict& verdict, const SizeOptions& prescribed,
                                 const SizeOptions& applied);

/// "; give --size 0.5 (about 560 quads) for a lower resolution ratio".
std::string describe(const Advice& advice);

}  // namespace quadrille::sizing
