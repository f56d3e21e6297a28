#include "occ/occ_parts_beside.hpp"

#include <TopExp_Explorer.hxx>

namespace quadrille::occ {

namespace {

// Whether the shape is a part of one of the faces.
bool belongs_to(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces) {
  for (const TopoDS_Face& face : faces)
    for (TopExp_Explorer part(face, shape.ShapeType()); part.More(); part.Next())
      if (part.Current().IsSame(shape)) return true;
  return false;
}

}  // namespace

std::vector<TopoDS_Shape> parts_beside(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, TopAbs_ShapeEnum around,
                                       const std::vector<TopoDS_Face>& faces) {
  std::vector<TopoDS_Shape> parts;
  for (TopExp_Explorer e(shape, kind, around); e.More(); e.Next())
    if (!belongs_to(e.Current(), faces)) parts.push_back(e.Current());
  return parts;
}

}  // namespace quadrille::occ
