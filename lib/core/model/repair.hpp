#pragma once
// What healing changed in the boundary of a CAD face (formats/tri-mesh.md, `repairs`).

#include <array>
#include <numbers>

#include "base/enum_names.hpp"
#include "base/vec2.hpp"

namespace quadrille {

enum class RepairKind {
  joint,   ///< the ends of two edges were moved to one point
  vertex,  ///< the vertex in the file lies off its edges, which meet
  plane,   ///< the edge was projected to the plane of the face
  edge,    ///< a short edge was removed
  cusp,    ///< the tip of a cusp was cut off
  fold,    ///< poles of a spline that ran back on itself were put in order
  knot,    ///< knots of a spline that lay close to each other or to its end were merged
  fit,     ///< a spline was replaced by one with fewer knots
};

constexpr auto enum_names(RepairKind) {
  return std::to_array({"joint", "vertex", "plane", "edge", "cusp", "fold", "knot", "fit"});
}

struct Repair {
  RepairKind kind = RepairKind::joint;
  int cad_edge = 0;     ///< number of the edge in the file; of the edge that ends there for a joint, vertex or cusp
  Vec2 position;        ///< in the coordinates of the file, face.origin included
  double distance = 0;  ///< how far it was moved, of a fit the most; the length of a removed edge or between merged
                        ///< knots, or that cut off both edges of a cusp
};

/// Radians: --blunt cuts the tips of corners below this angle off. Edges that meet at it take a number of elements
/// beside each other that grows like 1 / angle.
inline constexpr double blunted_angle = 0.2 * (std::numbers::pi / 180.0);

}  // namespace quadrille
