#pragma once
// The distance that irregular nodes keep from walls, so that layers fit below them (placement/keep_clearance).

#include <string>
#include <vector>

#include "model/cad_face.hpp"

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

/// By curve: the clearance of its wall, the greatest if there are several; 0: none.
std::vector<double> clearance_of_curves(const CadFace& face, const std::vector<WallClearance>& walls);

}  // namespace quadrille::placement
