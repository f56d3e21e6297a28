#include "occ/occ_completed_face.hpp"

#include <fmt/format.h>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <ShapeFix_Face.hxx>
#include <ShapeFix_Wire.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "base/error.hpp"
#include "occ/occ_poles.hpp"

namespace quadrille::occ {

namespace {

TopoDS_Face only_face(const TopoDS_Shape& shape, const std::string& file) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  if (faces.Extent() != 1)
    throw FormatError(fmt::format("{}: the boundary of the face divides it into {} parts: cut it in the CAD program",
                                  file, faces.Extent()));
  return TopoDS::Face(faces(1));
}

/// With `is_seam`: adds the seam of a closed surface, else parameter curves and poles. The kernel loses the parameter
/// curves if it does both at once.
TopoDS_Face completed_in_part(const TopoDS_Face& face, bool is_seam, const std::string& file) {
  const Handle(ShapeFix_Face) fix = new ShapeFix_Face(face);
  fix->FixSmallAreaWireMode() = 0, fix->FixIntersectingWiresMode() = 0, fix->FixSplitFaceMode() = 0;
  fix->RemoveSmallAreaFaceMode() = 0;
  fix->FixMissingSeamMode() = is_seam ? 1 : 0, fix->FixWireMode() = is_seam ? 0 : 1;
  const Handle(ShapeFix_Wire) wire = fix->FixWireTool();
  wire->ModifyTopologyMode() = Standard_False, wire->ModifyGeometryMode() = Standard_True;
  wire->FixSmallMode() = 0, wire->FixSelfIntersectionMode() = 0, wire->FixNotchedEdgesMode() = 0;
  wire->FixGaps3dMode() = 0, wire->FixGaps2dMode() = 0;
  fix->Perform();
  return only_face(fix->Result(), file);
}

}  // namespace

TopoDS_Face completed(const TopoDS_Face& face, const std::string& file) {
  return completed_in_part(completed_in_part(split_at_poles(face), false, file), true, file);
}

double box_diagonal(const TopoDS_Face& face) {
  Bnd_Box box;
  BRepBndLib::Add(face, box, Standard_False);
  if (box.IsVoid()) throw FormatError("the face has no extent");
  return std::sqrt(box.SquareExtent());
}

}  // namespace quadrille::occ
