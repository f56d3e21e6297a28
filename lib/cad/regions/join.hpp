#pragma once
// The struct of a face of several regions from those of its regions: the inverse of split.

#include <vector>

#include "model/critical_points.hpp"
#include "model/field.hpp"

namespace quadrille::regions {

/// `parts`: one for each region, in order; at least one. Of one region: the part itself, with the face `whole`.
TriMesh join(const CadFace& whole, std::vector<TriMesh> parts);

/// The fields must be of one kind, on the regions' parts of `whole`. Rounds of adaptation are joined from the first on;
/// a region with fewer rounds keeps its orders in the others.
Field join(const TriMesh& whole, std::vector<Field> parts);

/// The form is "phase" if that of one part is.
CriticalPoints join(const TriMesh& whole, std::vector<CriticalPoints> parts);

}  // namespace quadrille::regions
