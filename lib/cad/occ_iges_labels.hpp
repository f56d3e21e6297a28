#pragma once
// Reads the labels (name, layer, colour) of faces and edges in an IGES file.

#include <IGESData_IGESModel.hxx>
#include <Transfer_TransientProcess.hxx>

#include "cad/occ_model.hpp"

namespace quadrille::cad {

/// Fills model.labels from `file`; `process` is the transfer of the file to shapes. Labels are read from trimmed
/// surfaces (entity 144), and the lines, arcs and splines of their boundaries in space (110, 100, 126). Names are name
/// properties (406, form 15; the short labels of entities only state their kind), layers are "level_N" for levels other
/// than 0, and colours are read from the directory entries.
void add_iges_labels(const IGESData_IGESModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model);

}  // namespace quadrille::cad
