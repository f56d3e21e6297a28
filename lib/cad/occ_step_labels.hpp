#pragma once
// What a STEP file says about its faces and edges beside their shape, read from its entities as they are: no XCAF
// document, whose libraries would cost every start.

#include <StepData_StepModel.hxx>
#include <Transfer_TransientProcess.hxx>

#include "cad/occ_model.hpp"

namespace quadrille::cad {

/// Fills model.labels from `file`, whose transfer to shapes `process` did:
/// names of FACE_SURFACE and EDGE_CURVE; the first PRESENTATION_LAYER_ASSIGNMENT that lists the entity, its curve or a
/// STYLED_ITEM of it; the colour of the CURVE_STYLE of its STYLED_ITEM, of an overriding one if there is one.
void add_step_labels(const StepData_StepModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model);

}  // namespace quadrille::cad
