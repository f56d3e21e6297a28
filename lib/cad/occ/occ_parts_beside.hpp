#pragma once
// What a model has beside the chosen faces.

#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace quadrille::occ {

/// The parts of a kind that are in no shape of the kind `around`, and in none of the faces.
std::vector<TopoDS_Shape> parts_beside(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum around,
                                       const std::vector<TopoDS_Face>& faces);

}  // namespace quadrille::occ
