#pragma once
// Finds errors in a STEP file on which OpenCASCADE's reader crashes. Text only, no OpenCASCADE types.

#include <string>

namespace quadrille::cad {

/// The first invalid reference between entities of a STEP file: to an entity that does not exist, or to one of a wrong
/// type ("#22 VERTEX_POINT refers to #23, which is of type DIRECTION, not CARTESIAN_POINT"). Empty if no such error is
/// found; types are checked only for the entities that make up faces.
std::string step_fault(const std::string& bytes);

}  // namespace quadrille::cad
