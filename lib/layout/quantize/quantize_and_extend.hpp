#pragma once
// A conforming layout from a T-mesh: of a face, of joined regions, and across periodic sides.
//
// A T-mesh with integer lengths is extended to a conforming graph (lib/method.md §9.7): every line that stops at a
// T-junction continues through the integer grids of the faces, until it meets the boundary, or a T-junction from the
// other side, whose line it joins. These lines and the lines of the T-mesh are all lines that start at irregular nodes
// in the integer grid: they bound its largest four-sided blocks (base complex).
//
// In a face, lines are images of straight lines of the unit square under the face's transfinite map
// (mesh/transfinite.hpp), so that lines of one direction never cross; arcs are split where lines cross them.

#include <functional>
#include <vector>

#include "base/progress.hpp"
#include "curve/chain.hpp"
#include "graph/candidate_layout.hpp"
#include "quantize/quantize.hpp"
#include "quantize/quantized_parametrization.hpp"

namespace quadrille::quantize {

/// Of each arc of the T-mesh: the arcs that it is split into, in its direction.
using ArcParts = std::vector<std::vector<int>>;

/// Splits the arcs of `subdivision`, a T-mesh, at these fractions of their lengths. `chains`: of the arcs.
ArcParts split_arcs(const std::vector<curve::Chain>& chains, const CrossingFractions& fractions,
                    graph::Subdivision& subdivision);

/// The half-edge that ends at a position on a side of a face: at a crossing, or at the end of an arc.
HalfEdge part_before(const QuantizedParametrization& parametrization, const ArcParts& parts, int face, int side,
                     int position);

/// A T-mesh with the iso-lines of its parametrization; `table`: of its curves, `parts`: of its arcs.
struct ParametrizedTMesh {
  const ArcGraph& graph;
  const curve::CurveTable& table;
  const QuantizedParametrization& parametrization;
  const ArcParts& parts;
};

/// Divides a face of the T-mesh by its iso-lines: adds a spline and arcs for each, a node where two of them cross, and
/// lines of kind LineKind::extended. `layout`: of the T-mesh, with split arcs.
void draw_iso_lines(const ParametrizedTMesh& t_mesh, int face, graph::CandidateLayout& layout);

/// Extends a T-mesh. `lengths` (1 or more for each arc, opposite sides of the faces equal): of quantize(). Nodes of the
/// T-mesh keep their numbers. `same`, of each arc (model/periodic.hpp): of arcs of periodic sides, the one that it is
/// the image of; lines that leave through one enter through the other, at equal fractions; both must have one length.
/// Throws ComputeError if the result has a face without four corners, or if lines run across each other at a node
/// (faces that are much thinner than their sides are curved).
graph::CandidateLayout extend_lines(const graph::CandidateLayout& t_mesh, const std::vector<TFace>& faces,
                                    const std::vector<int>& lengths, const std::vector<HalfEdge>& same = {});

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
/// of the diameter long, and extends its lines through the integer grids of its faces. A T-mesh without such lengths is
/// replaced until there are some. With glued periodic sides, an arc and its image must be arcs of the T-mesh, and have
/// one length.
ExtendedTMesh quantize_and_extend(graph::CandidateLayout t_mesh, PeriodicSides sides, const ReplaceTMesh& replace,
                                  Progress* progress);

}  // namespace quadrille::quantize
