#pragma once
// Extracts the only face of an OpenCASCADE model, as NURBS in its plane.

#include "base/report.hpp"
#include "cad/occ_model.hpp"
#include "heal/raw_face.hpp"

namespace quadrille::cad {

/// Throws FormatError unless `model` contains exactly one planar face bounded by plain wires; other entities of the
/// model are reported as warnings. `file`: name of the file, for messages.
heal::RawFace occ_face(const OccModel& model, const std::string& file, Report& report);

}  // namespace quadrille::cad
