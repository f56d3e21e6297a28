#pragma once
// An arc in one of its two directions: the side of a face, a step of a path, a line as it starts at a node.
//
//     arc 7:   from o------------>o to       {7}        forwards: from `from` to `to`, the arc's left side
//                                            {7, true}  backwards: from `to` to `from`, the arc's right side

#include <compare>
#include <cstddef>

namespace quadrille {

struct HalfEdge {
  int arc = -1;
  bool is_backwards = false;

  constexpr HalfEdge reversed() const { return {arc, !is_backwards}; }
  /// Index in tables over half-edges: 2 * arc forwards, 2 * arc + 1 backwards.
  constexpr std::size_t index() const { return 2 * static_cast<std::size_t>(arc) + (is_backwards ? 1 : 0); }
  constexpr auto operator<=>(const HalfEdge&) const = default;  ///< by index
};

/// The start node and the end node of a half-edge. `arcs` have members `from` and `to`.
template <typename Arcs>
int start_of(const Arcs& arcs, HalfEdge h) {
  return h.is_backwards ? arcs[h.arc].to : arcs[h.arc].from;
}
template <typename Arcs>
int end_of(const Arcs& arcs, HalfEdge h) {
  return start_of(arcs, h.reversed());
}

/// The code in files (formats/block-layout.md): arc forwards, -1 - arc backwards.
constexpr int file_code(HalfEdge h) { return h.is_backwards ? -1 - h.arc : h.arc; }
constexpr HalfEdge half_edge_of_code(int code) { return code < 0 ? HalfEdge{-1 - code, true} : HalfEdge{code, false}; }

}  // namespace quadrille
