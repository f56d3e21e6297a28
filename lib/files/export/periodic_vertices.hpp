#pragma once
// Periodic sides as formats state them that know elements by their vertices: the vertices of both sides are one.

#include <string>
#include <vector>

#include "export/edge_numbering.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct PeriodicVertices {
  /// By vertex of the numbering: the vertex of least number that it is identified with. Empty: there are no such sides,
  /// or they are not identified (`loss`).
  std::vector<int> same;
  std::string loss;  ///< why the sides are not identified; empty if they are

  bool are_identified() const { return !same.empty(); }
  int operator()(int vertex) const { return are_identified() ? same[vertex] : vertex; }
};

/// Which periodic sides are identified.
enum class Motions { all, translations };

/// A program that knows edges by their ends must be able to distinguish them afterwards: sides are not identified if
/// two edges would have the same ends, or an edge twice the same one. `reader` is the program, for the sentence.
PeriodicVertices periodic_vertices(const QuadMesh& mesh, const EdgeNumbering& numbering, Motions motions,
                                   const char* reader);

}  // namespace quadrille::exports
