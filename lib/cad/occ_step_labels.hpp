#pragma once
// Reads the labels (name, layer, colour) of faces and edges in a STEP file, directly from its entities. An XCAF
// document is not used, because its libraries would slow down every start.

#include <StepData_StepModel.hxx>
#include <Transfer_TransientProcess.hxx>

#include "cad/occ_model.hpp"

namespace quadrille::cad {

/// Fills model.labels from `file`; `process` is the transfer of the file to shapes. The name of a
/// label is read from FACE_SURFACE or EDGE_CURVE, its layer from the first PRESENTATION_LAYER_ASSIGNMENT that lists the
/// entity, its curve or a STYLED_ITEM of it, and its colour from the CURVE_STYLE of the STYLED_ITEM of the entity, or
/// of an overriding STYLED_ITEM if there is one.
void add_step_labels(const StepData_StepModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model);

}  // namespace quadrille::cad
