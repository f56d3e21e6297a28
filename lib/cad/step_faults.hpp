#pragma once
// What a person can be told about a STEP file on which the CAD kernel's reader crashes. No kernel here: text only.

#include <string>

namespace quadrille::cad {

/// The first fault in the net of entities of a STEP file: a reference to an entity that is not there, or to one of a
/// wrong type ("#22 VERTEX_POINT refers to #23, which is of type DIRECTION, not CARTESIAN_POINT"). Empty where no fault
/// of these kinds is found; only the entities that make up faces are judged by type.
std::string step_fault(const std::string& bytes);

}  // namespace quadrille::cad
