#pragma once
// Periodic sides of a mesh, as formats with periodic boundaries need them.
//
// Periodic sides as formats state them that know elements by their vertices: the vertices of both sides are one.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "export/edge_numbering.hpp"
#include "export/exported.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// Two boundary edges of which one is the image of the other, in the opposite direction.
struct PeriodicEdges {
  int first = 0, second = 0;  ///< of QuadMesh::boundary_edges: on the first and on the second curve of the pair
  int pair = 0;               ///< of CadFace::periodic_pairs
};

/// Throws ComputeError, with the place, for an edge on a periodic curve that has no image within 1e-9 diameters.
std::vector<PeriodicEdges> periodic_edges(const QuadMesh& mesh);

/// A motion row by row: it maps (x, y, z, 1) of a point to its image.
std::array<double, 16> affine_motion(const SpaceMotion& motion);

/// The motion of a pair in a frame, row by row: it maps (x, y, z, 1) of the first curve onto the second. Of a curved
/// face the motion in space.
std::array<double, 16> affine_motion(const CadFace& face, int pair, const Frame& frame);

/// Those pairs whose motion is a translation, and the others. Discontinuous Galerkin methods that take the normal of
/// one side for both couple the former only.
std::vector<PeriodicPair> translated_pairs(const CadFace& face);
std::vector<PeriodicPair> rotated_pairs(const CadFace& face);

/// The names of the sides, pair by pair: "left" and "right"; "bottom" and "top".
std::string periodic_names(const CadFace& face, const std::vector<PeriodicPair>& pairs);

/// A sentence that the format does not store that the sides of `pairs` are periodic, and why, if that is not empty.
/// Empty if there are no pairs.
std::string periodic_loss(const CadFace& face, const std::vector<PeriodicPair>& pairs, std::string_view why = {});

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
