#pragma once
// Which of the things that a CAD file says about an edge becomes its name. No kernel here.

#include "cad/raw_face.hpp"

namespace quadrille::cad {

/// Sets RawEdge::name, and RawFace::name, by what the file says, the first of these that is there:
///   1. the edge's own name,
///   2. its layer, unless the face is on that layer too: then it is the layer of the part,
///   3. its colour, as "colour_ff0000", unless all of several edges have one colour.
/// A face without name gets its layer's, unless an edge is on that one too. Where nothing is there names stay empty.
void choose_names(RawFace& raw);

}  // namespace quadrille::cad
