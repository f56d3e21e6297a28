#pragma once
// Selects the name of an edge among the labels in a CAD file. No OpenCASCADE types.

#include "heal/raw_face.hpp"

namespace quadrille::cad {

/// Sets RawEdge::name, and RawFace::name, from the labels of the file. The first of these that exists is used:
///   1. the edge's own name,
///   2. its layer, unless the face is on the same layer (then it is the layer of the part),
///   3. its colour, as "colour_ff0000", unless there are several edges and all have the same colour.
///
/// A face without a name gets the name of its layer, unless an edge is on the same layer. Without any label, names stay
/// empty.
void choose_names(heal::RawFace& raw);

}  // namespace quadrille::cad
