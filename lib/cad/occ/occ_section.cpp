#include "occ/occ_section.hpp"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Pln.hxx>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "occ/occ_face.hpp"
#include "occ/occ_model.hpp"

namespace quadrille::occ {
namespace {

// Of the diagonal of the model's box.
constexpr double near = 1e-7;        ///< distance of a face from a plane that it lies in
constexpr double negligible = 1e-9;  ///< distance of a curve of the cut from its face

Bnd_Box box_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, false);
  return box;
}

/// Coordinates of a box along the normal, from the plane.
std::array<double, 2> range_of(const Bnd_Box& box, const gp_Pln& plane) {
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  std::array<double, 2> range{HUGE_VAL, -HUGE_VAL};
  for (int corner = 0; corner < 8; ++corner) {
    const gp_Pnt x((corner & 1 ? high : low).X(), (corner & 2 ? high : low).Y(), (corner & 4 ? high : low).Z());
    const double height = gp_Vec(plane.Location(), x).Dot(plane.Axis().Direction());
    range = {std::min(range[0], height), std::max(range[1], height)};
  }
  return range;
}

/// The greatest distance of a curve from a surface, from samples; 0 for lines and conics, which the kernel finds
/// exactly.
double distance_between(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  constexpr int num_samples = 33;
  const BRepAdaptor_Curve curve(edge);
  if (curve.GetType() <= GeomAbs_Parabola) return 0;
  const double first = curve.FirstParameter(), step = (curve.LastParameter() - first) / (num_samples - 1);
  double greatest = 0;
  for (int i = 0; i < num_samples; ++i) {
    const GeomAPI_ProjectPointOnSurf foot(curve.Value(first + i * step), BRep_Tool::Surface(face));
    if (foot.NbPoints() > 0) greatest = std::max(greatest, foot.LowerDistance());
  }
  return greatest;
}

/// A face of the plane that reaches beyond the box.
TopoDS_Face face_of_plane(const gp_Pln& plane, const Bnd_Box& box) {
  const double reach = 1.1 * (box.CornerMin().Distance(box.CornerMax()) + plane.Location().Distance(box.CornerMin()));
  return BRepBuilderAPI_MakeFace(plane, -reach, reach, -reach, reach);
}

/// Makes the model of the cut, whose tree of shapes is that of the file with the faces of the cut in place of solids.
class Cutter {
 public:
  Cutter(const OccModel& model, const gp_Pln& plane, const std::string& name)
      : model_(model), plane_(plane), name_(name), box_(box_of(model.shape)) {
    for (const TopoDS_Face& face : faces_of(model)) numbers_.Add(face);
    result_.length_unit = model.length_unit;
    result_.metres_per_unit = model.metres_per_unit;
    result_.tolerance = model.tolerance;
  }

  OccModel cut(Report& report) {
    if (model_.num_solids == 0)
      throw FormatError(
          fmt::format("{}: --section cuts solids, and the file holds none ({}): sew the faces to a solid "
                      "in the CAD program",
                      name_, counted(model_.num_faces, "face")));
    result_.shape = cut_shape(model_.shape);
    if (result_.num_faces == 0) {
      const auto [low, high] = range_of(box_, plane_);
      throw FormatError(
          fmt::format("{}: the plane of --section cuts no solid: along its normal the model reaches from "
                      "{:.6g} to {:.6g}, measured from the plane",
                      name_, low, high));
    }
    if (greatest_distance_ > negligible * size())
      report.warn(warning::edge_approximated,
                  fmt::format("{}: the plane of --section cuts curves that are no conics: the CAD kernel approximates "
                              "them, up to {:.2g} off the faces",
                              name_, greatest_distance_));
    return std::move(result_);
  }

 private:
  TopoDS_Compound cut_shape(const TopoDS_Shape& shape) {
    TopoDS_Compound made;
    builder_.MakeCompound(made);
    if (shape.ShapeType() == TopAbs_SOLID)
      cut_solid(shape, made);
    else if (shape.ShapeType() < TopAbs_SOLID)
      for (TopoDS_Iterator i(shape); i.More(); i.Next()) builder_.Add(made, cut_shape(i.Value()));
    if (const auto part = model_.parts.find(shape.TShape().get()); part != model_.parts.end())
      result_.parts[made.TShape().get()] = part->second;
    return made;
  }

  void cut_solid(const TopoDS_Shape& solid, TopoDS_Compound& made) {
    if (box_of(solid).IsOut(plane_)) return;
    require_no_face_in_plane(solid);
    TopTools_ListOfShape planes, solids;
    planes.Append(face_of_plane(plane_, box_));
    solids.Append(solid);
    BRepAlgoAPI_Common common;
    common.SetArguments(planes);
    common.SetTools(solids);
    common.Build();
    if (common.HasErrors())
      throw FormatError(name_ +
                        ": the CAD kernel cannot cut a solid by the plane of --section: move the plane a little");
    for (TopExp_Explorer face(common.Shape(), TopAbs_FACE); face.More(); face.Next()) {
      builder_.Add(made, face.Current());
      ++result_.num_faces;
    }
    for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next())
      for (const TopoDS_Shape& edge : common.Generated(face.Current()))
        if (edge.ShapeType() == TopAbs_EDGE) add_edge(TopoDS::Edge(edge), TopoDS::Face(face.Current()));
  }

  void add_edge(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    result_.labels[edge.TShape().get()] = {edge, label_of(face)};
    greatest_distance_ = std::max(greatest_distance_, distance_between(edge, face));
  }

  double size() const { return box_.CornerMin().Distance(box_.CornerMax()); }

  ShapeLabel label_of(const TopoDS_Shape& face) const {
    ShapeLabel label = model_.label_of(face);
    if (label.name.empty()) label.name = fmt::format("face_{}", number_of(face));
    return label;
  }

  int number_of(const TopoDS_Shape& face) const { return numbers_.FindIndex(face) - 1; }

  // Beside such a face the solid has another cut on either side of the plane.
  void require_no_face_in_plane(const TopoDS_Shape& solid) const {
    for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
      const auto plane = plane_of(TopoDS::Face(face.Current()));
      if (!plane || !plane->Axis().IsParallel(plane_.Axis(), Precision::Angular())) continue;
      if (plane_.Distance(plane->Location()) <= near * size())
        throw FormatError(
            fmt::format("{}: face {} of a solid lies in the plane of --section: move the plane to one "
                        "side of it, or choose that face by --face {} without --section",
                        name_, number_of(face.Current()), number_of(face.Current())));
    }
  }

  const OccModel& model_;
  gp_Pln plane_;
  std::string name_;
  Bnd_Box box_;
  TopTools_IndexedMapOfShape numbers_;  ///< of the faces, from 1
  BRep_Builder builder_;
  OccModel result_;
  double greatest_distance_ = 0;  ///< of an edge of the cut from the face that it lies in
};

}  // namespace

OccModel section(const OccModel& model, const cad::SectionPlane& plane, const std::string& name, Report& report) {
  const gp_Pln cut(gp_Pnt(plane.point.x, plane.point.y, plane.point.z),
                   gp_Dir(plane.normal.x, plane.normal.y, plane.normal.z));
  return Cutter(model, cut, name).cut(report);
}

}  // namespace quadrille::occ
