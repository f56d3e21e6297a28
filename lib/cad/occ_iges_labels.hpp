#pragma once
// What an IGES file says about its faces and edges beside their shape.

#include <IGESData_IGESModel.hxx>
#include <Transfer_TransientProcess.hxx>

#include "cad/occ_model.hpp"

namespace quadrille::cad {

/// Fills model.labels from `file`, whose transfer to shapes `process` did: trimmed surfaces (entity 144), and the
/// lines, arcs and splines of their boundaries in space (110, 100, 126). Names are name properties (406, form 15; the
/// short labels of entities are mere kinds), layers are "level_N" for levels other than 0, colours those of the
/// directory.
void add_iges_labels(const IGESData_IGESModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model);

}  // namespace quadrille::cad
