#pragma once
// New names for the boundary curves of a face, from a JSON object {"old name or number of a curve": "new name"}.

#include "io/input_file.hpp"
#include "model/cad_face.hpp"

namespace quadrille {

/// Renames face.curve_names. A key is the present name of one or more curves, or the number of one (base 0, as the
/// pictures show it). Several curves may get the same name: they form one group. Throws FormatError for anything that
/// is no such object, for a key that meets no curve and for an empty name.
void rename_boundary(CadFace& face, const InputFile& file);

}  // namespace quadrille
