#pragma once
// Refuses placements of parts in a STEP file that OpenCASCADE would read wrongly.

#include <StepData_StepModel.hxx>
#include <string>

namespace quadrille::occ {

/// OpenCASCADE reads a CARTESIAN_TRANSFORMATION_OPERATOR_3D without its scale, and a mirror as a rotation. Throws
/// FormatError if one that places a part (of a MAPPED_ITEM, or between two representations) would be read as another
/// map than that of ISO 10303-42. `name`: name of the file, for messages.
void require_readable_placements(const StepData_StepModel& file, const std::string& name);

}  // namespace quadrille::occ
