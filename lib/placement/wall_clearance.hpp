#pragma once
// The distance that irregular nodes keep from walls, so that layers fit below them: a term of the objective of
// placement
//
//   strength (reach / r - 1)^3   for r < reach, else 0,        r the distance to the wall, reach 1.5 times the
//   clearance
//
// whose strength is raised until the nodes keep the clearance, or have no room to.

#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::placement {

/// Boundary curves from which nodes keep a distance.
struct WallClearance {
  std::vector<int> curves;
  double clearance = 0;  ///< a length
};

/// NAME=L of the command line.
struct NamedClearance {
  std::string name;
  double clearance = 0;
};

/// Throws UsageError with the text, if it is not NAME=L with L > 0.
NamedClearance parse_clearance(const std::string& text);

/// Throws UsageError for names that no boundary of the face has.
std::vector<WallClearance> wall_clearances(const CadFace& face, const std::vector<NamedClearance>& named);

/// Distance to the nearest curve of the wall, and its gradient.
double distance_to_wall(const CadFace& face, const WallClearance& wall, Vec2 x, Vec2& gradient);

/// By node: whether it is nearer to a wall than the wall's clearance, by more than 1e-6 of it.
std::vector<bool> nodes_near_walls(const CadFace& face, const std::vector<WallClearance>& walls,
                                   const CriticalPoints& points);

/// The term of one wall for the node at x; adds its gradient.
double clearance_energy(const CadFace& face, const WallClearance& wall, double strength, Vec2 x, Vec2& gradient);

}  // namespace quadrille::placement
