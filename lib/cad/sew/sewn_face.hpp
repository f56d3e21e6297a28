#pragma once
// One face of several regions from the faces of a file.

#include <vector>

#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"
#include "model/repair.hpp"
#include "outline/face_of_loops.hpp"
#include "sew/sew_regions.hpp"

namespace quadrille::sew {

/// The face of all regions, in the plane and the unit of `raw`; `corner_angle`: as in outline::AssembleOptions. Joints
/// are those of each region by itself. Both sides of an interface have the name that one of them has in the file, the
/// first one's if both have; the others are unnamed (cad/region_names.hpp). Regions without a name are called
/// "region_N". A single region has no arrays of regions, except `partners` if it has slits.
CadFace face_of_regions(const Sewn& sewn, const heal::RawFace& raw, double corner_angle);

struct SewOptions {
  double corner_angle = 0.017453292519943295;  ///< as in outline::AssembleOptions, like the next two
  double blunt_width = 0;
  double fit_tolerance = 0;
  double heal_tolerance = -1;     ///< as in heal::HealOptions; sewing has the same, in diameters of the whole
  outline::FacePiece piece = {};  ///< of a single face
};

/// Whether there is anything to do for sewn_face: several faces, inner or free edges, or inner wires that are not
/// closed.
bool are_to_be_sewn(const std::vector<heal::RawFace>& faces, const std::vector<heal::RawEdge>& free_edges);

/// Heals each face by itself (heal_face.hpp, assemble_face.hpp), embeds curves (inner_curves.hpp), sews the faces and
/// makes one face of them. `faces`: in the plane of the first, their edges numbered from 0, like `free_edges`; the
/// numbers of the result count on from face to face. A single face without embedded curves has no regions.
/// Adds what healing changed to `repairs`. Throws FormatError, with the faces, the place, the size and a remedy, for
/// what healing refuses, for faces that are not in one plane, and for those that require_one_sheet refuses.
CadFace sewn_face(std::vector<heal::RawFace> faces, std::vector<heal::RawEdge> free_edges, const SewOptions& options,
                  std::vector<Repair>& repairs, Report& report);

}  // namespace quadrille::sew
