#pragma once
// The faces of a T-mesh (quantize/t_mesh.hpp), with four sides each and T-junctions on them, and integer lengths for
// its arcs such that opposite sides of every face have equal sums: each face is then an integer grid, and the grids of
// all faces fit together (Campen, Bommes and Kobbelt 2015; Lyon, Campen and Kobbelt 2021; Heistermann, Warnett and
// Bommes 2023).
//
//   minimise  sum_a (n_a - t_a)^2 / max(t_a, 1/2)    n_a >= 1 integer,    t_a = length of arc a / unit
//
// with the squares piecewise linear between integers. Arcs whose lengths in the plane have a relative difference below
// 1e-6, such as a symmetry orbit, are assigned the same integer length if such a solution exists (the sum of a
// solution's images under a symmetry is one).
//
// Large T-meshes get lengths by augmenting paths, in near linear time. Every arc lies on at most two sides of faces, so
// that the equations "opposite sides are equal" are those of a flow in a bidirected graph: its nodes are the two pairs
// of opposite sides of each face, its edges the arcs, and an arc on the boundary has one free end. Lengths start at the
// integers nearest to their targets. A node whose two sides differ is balanced by a path of least cost along which
// lengths rise or fall by 1, to a node that lacks the opposite or to the boundary. Where holes are everywhere, paths
// are short.

#include <array>
#include <vector>

#include "graph/subdivision.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::quantize {

/// A face of a T-mesh: the half-edges of its four sides, counter-clockwise.
using TFace = std::array<std::vector<HalfEdge>, 4>;

/// Throws ComputeError with a position unless every face has four corners and all its other sectors are half turns.
std::vector<TFace> t_mesh_faces(const graph::Subdivision& subdivision);

/// Lengths >= 1 with small sum (n_a - t_a)^2 / max(t_a, 1/2), `targets` the t_a: feasible, but not proved the least,
/// and not the same for symmetric arcs. If a node cannot be balanced, there is no solution: all that its paths reach is
/// a strip of faces that winds onto itself.
struct FlowLengths {
  std::vector<int> lengths;              ///< of all arcs; empty if there is no solution
  std::vector<std::vector<int>> strips;  ///< the arcs along each strip that was found, ascending; then empty `lengths`
};
FlowLengths flow_lengths(const std::vector<TFace>& faces, const std::vector<double>& targets);

/// `arc_lengths` and `unit`: lengths. Returns integer lengths of the arcs, 1 or more; empty if there are none.
std::vector<int> quantize(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit);

/// Integer lengths, or why there are none.
struct Quantization {
  std::vector<int> lengths;
  /// Without lengths: the arcs along strips that wind onto themselves, ascending. One strip as
  /// infeasibility_certificate finds it; in a large T-mesh all that were found. Empty if none was.
  std::vector<std::vector<int>> strips;
};

/// As quantize; lengths of more than 2000 arcs are nearly as good, not necessarily symmetric, and found in near linear
/// time.
Quantization quantize_or_explain(const std::vector<TFace>& faces, const std::vector<double>& arc_lengths, double unit);

/// Arcs that are zero in every solution with lengths >= 0: they cross strips of faces that wind onto themselves. If
/// there are none, quantize() succeeds.
std::vector<int> forced_zero_arcs(const std::vector<TFace>& faces, int num_arcs);

/// Why an arc is zero in every solution: multipliers y of the equations whose sum has no negative coefficient and a
/// positive one at this arc, with the least sum |y| (Farkas' lemma). The faces with y != 0 are the strip that winds
/// onto itself; the result is the arcs along it, ascending: if their lines ran differently, the strip might not do so.
std::vector<int> infeasibility_certificate(const std::vector<TFace>& faces, int num_arcs, int zero_arc);

}  // namespace quadrille::quantize
