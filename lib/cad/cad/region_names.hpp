#pragma once
// Names of regions and of the curves that they share; neighbours of one name as one region. No OpenCASCADE types.

#include <vector>

#include "model/cad_face.hpp"
#include "model/name_rules.hpp"

namespace quadrille::cad {

/// Names the interfaces without a given name after the two regions, the one with the lower number first: "fluid-solid";
/// the second side of a slit without a given name like the first.
void name_interfaces(CadFace& face);

/// Sets the names of regions by `rules` of the kinds range, pattern, position and rest; old names are those before the
/// first rule, and a position is a point inside the region. The name of a single region is that of the face. Names
/// interfaces anew. Returns the numbers of the regions that were named, ascending. Throws FormatError, with the
/// position of the rule in its source, for a rule without a region, a point that is in none or on the boundary of one,
/// and for two rules that name the same region.
std::vector<int> rename_regions(CadFace& face, const std::vector<NameRule>& rules);

/// Removes the curves between regions of `named` that have one name: regions that such curves connect are one region,
/// in the place of the first of them. Curves, loops and unnamed curves are numbered anew; if one region is left, it is
/// the face, with its name. `corner_angle`, radians: a greater tangent jump is a corner. Throws FormatError, with the
/// name and the place, for a region that would touch itself in a point.
void merge_regions(CadFace& face, const std::vector<int>& named, double corner_angle);

}  // namespace quadrille::cad
