#pragma once
// A conforming layout from a T-mesh: of a face, of joined regions, and across periodic sides.

#include <functional>
#include <vector>

#include "base/progress.hpp"
#include "graph/candidate_layout.hpp"
#include "quantize/t_mesh_faces.hpp"

namespace quadrille::quantize {

/// A T-mesh without integer lengths: a strip of its faces winds onto itself.
struct InfeasibleTMesh {
  const graph::CandidateLayout& t_mesh;
  const std::vector<TFace>& faces;              ///< across periodic sides, if they are glued
  const std::vector<std::vector<int>>& strips;  ///< Quantization::strips

  /// The arcs that are zero in every solution.
  std::vector<int> zero_arcs() const;
};

/// Another T-mesh of the same face, if one has no integer lengths. Throws ComputeError if no other can be made.
using ReplaceTMesh = std::function<graph::CandidateLayout(const InfeasibleTMesh&)>;

/// What lies beyond a periodic side: nothing, as beyond any boundary, or the face inside the other side.
enum class PeriodicSides { separate, glued };

struct ExtendedTMesh {
  graph::CandidateLayout layout;
  int longest_arc = 0;  ///< integer length
};

/// Finds integer lengths for the arcs of a T-mesh (quantize/quantize.hpp), an arc of integer length one being a tenth
/// of the diameter long, and extends its lines through the integer grids of its faces (quantize/extend_lines.hpp). A
/// T-mesh without such lengths is replaced until there are some. With glued periodic sides, an arc and its image must
/// be arcs of the T-mesh, and have one length.
ExtendedTMesh quantize_and_extend(graph::CandidateLayout t_mesh, PeriodicSides sides, const ReplaceTMesh& replace,
                                  Progress* progress);

}  // namespace quadrille::quantize
