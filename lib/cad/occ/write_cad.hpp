#pragma once
// Writes blocks and faces as CAD files. No OpenCASCADE types.

#include <string>

#include "model/block_layout.hpp"

namespace quadrille::occ {

/// One shell with one face for each block, named as the block, in the plane of the CAD face in space, or on the surface
/// of a curved one with its normal, and in the length unit of the CAD file (millimetre if that is unknown or STEP has
/// no name for it). Every piece of an arc is one edge, shared by the faces on both sides; vertices are shared likewise;
/// edges on the boundary carry the name of their CAD curve. Straight pieces are lines, circular ones circles, the
/// others exact rational B-splines. Equal layouts produce equal bytes. On a surface, edges inside are cubic splines
/// within 1e-7 diameters of it, and all have a curve in its parameters too. Throws ComputeError if the arcs of a layout
/// do not meet.
std::string step_of_blocks(const BlockLayout& layout);

/// The face, with one edge for each curve, in the same way; several regions as a shell of faces that share the edges of
/// common curves. Only edges and regions with a given name are named.
std::string step_of_face(const CadFace& face);

/// Whether STEP files are written in the face's unit: metres with any prefix, inch, foot, mile, mil, microinch; or it
/// is unknown.
bool has_step_unit(const CadFace& face);

/// The same in OpenCASCADE's own format, which has no names and no unit.
std::string brep_of_face(const CadFace& face);

}  // namespace quadrille::occ
