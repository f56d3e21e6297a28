#pragma once
// Integer lengths for the arcs of a large T-mesh by augmenting paths, in near linear time.
//
// Every arc lies on at most two sides of faces, so that the equations "opposite sides are equal" are those of a flow in
// a bidirected graph: its nodes are the two pairs of opposite sides of each face, its edges the arcs, and an arc on the
// boundary has one free end (Heistermann, Warnett and Bommes 2023). Lengths start at the integers nearest to their
// targets. A node whose two sides differ is balanced by a path of least cost along which lengths rise or fall by 1, to
// a node that lacks the opposite or to the boundary. Where holes are everywhere, paths are short.

#include <vector>

#include "quantize/t_mesh_faces.hpp"

namespace quadrille::quantize {

/// Lengths >= 1 with small sum (n_a - t_a)^2 / max(t_a, 1/2), `targets` the t_a: feasible, but not proved the least,
/// and not the same for symmetric arcs. If a node cannot be balanced, there is no solution: all that its paths reach is
/// a strip of faces that winds onto itself.
struct FlowLengths {
  std::vector<int> lengths;              ///< of all arcs; empty if there is no solution
  std::vector<std::vector<int>> strips;  ///< the arcs along each strip that was found, ascending; then empty `lengths`
};
FlowLengths flow_lengths(const std::vector<TFace>& faces, const std::vector<double>& targets);

}  // namespace quadrille::quantize
