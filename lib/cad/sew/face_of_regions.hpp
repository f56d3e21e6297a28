#pragma once
// From sewn regions to one CadFace.

#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"
#include "sew/sew_regions.hpp"

namespace quadrille::sew {

/// The face of all regions, in the plane and the unit of `raw`; `corner_angle`: as in outline::AssembleOptions. Joints
/// are those of each region by itself. Both sides of an interface have the name that one of them has in the file, the
/// first one's if both have; the others are unnamed (cad/region_names.hpp). Regions without a name are called
/// "region_N". A single region has no arrays of regions, except `partners` if it has slits.
CadFace face_of_regions(const Sewn& sewn, const heal::RawFace& raw, double corner_angle);

}  // namespace quadrille::sew
