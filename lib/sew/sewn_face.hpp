#pragma once
// One face of several regions from the faces of a file.

#include <vector>

#include "base/report.hpp"
#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"
#include "model/repair.hpp"

namespace quadrille::sew {

struct SewOptions {
  double corner_angle = 0.017453292519943295;  ///< as in outline::AssembleOptions, like the next two
  double blunt_width = 0;
  double fit_tolerance = 0;
  double heal_tolerance = -1;  ///< as in heal::HealOptions; sewing has the same, in diameters of the whole
};

/// Heals each face by itself (heal_face.hpp, assemble_face.hpp), sews them and makes one face of them. `faces`: two or
/// more, in the plane of the first, their edges numbered from 0; the numbers of the result count on from face to face.
/// Adds what healing changed to `repairs`. Throws FormatError, with the faces, the place, the size and a remedy, for
/// what healing refuses, for faces that are not in one plane, and for those that require_one_sheet refuses.
CadFace sewn_face(std::vector<heal::RawFace> faces, const SewOptions& options, std::vector<Repair>& repairs,
                  Report& report);

}  // namespace quadrille::sew
