#pragma once
// Reads the labels (name, layer, colour) of faces, edges and the parts that hold faces, directly from the entities of
// the file. An XCAF document is not used, because its libraries would slow down every start. One source file for each
// format.

#include <IGESData_IGESModel.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_TransientProcess.hxx>
#include <string>

#include "occ/occ_model.hpp"

namespace quadrille::occ {

/// The name that a string entity states, cleaned. Empty for what programs write where nobody gave a name: NONE, and
/// OpenCASCADE's names for products and references ("Open CASCADE STEP translator 7.6 4.1", "=>[0:1:1:2]").
std::string given_name(const Handle(TCollection_HAsciiString) & text);

/// Fills model.labels from `file`; `process` is the transfer of the file to shapes. The name of a
/// label is read from FACE_SURFACE or EDGE_CURVE, its layer from the first PRESENTATION_LAYER_ASSIGNMENT that lists the
/// entity, its curve or a STYLED_ITEM of it, and its colour from the CURVE_STYLE of the STYLED_ITEM of the entity, or
/// of an overriding STYLED_ITEM if there is one. Fills model.parts with the names of products, and the names and layers
/// of solids, surface models and shells.
void add_step_labels(const StepData_StepModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model);

/// Fills model.labels and model.parts from `file`; `process` is the transfer of the file to shapes. Labels are read
/// from faces (trimmed surfaces, entity 144, and faces of solids, 510), the lines, arcs and splines of the boundaries
/// of trimmed surfaces in space (110, 100, 126), and what holds faces (solids 186, shells 514, groups 402, instances of
/// subfigures 408). Names are name properties (406, form 15; the short labels of entities only state their kind) or
/// those of subfigures, layers are "level_N" for levels other than 0, and colours are read from the directory entries.
void add_iges_labels(const IGESData_IGESModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model);

}  // namespace quadrille::occ
