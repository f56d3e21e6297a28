#include "occ/occ_face.hpp"

#include <fmt/format.h>

#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/nurbs.hpp"
#include "occ/occ_curves.hpp"

namespace quadrille::occ {
namespace {

// Adding 0.0 turns negative zeros into positive ones.
std::array<double, 3> numbers(const gp_XYZ& v) { return {v.X() + 0.0, v.Y() + 0.0, v.Z() + 0.0}; }

// In a plane parallel to two axes, their coordinates are used: (x, y), (y, z) or (x, z). Any other plane has the axes
// of the file.
PlaneFrame frame_of(const gp_Pln& plane) {
  const gp_XYZ normal = plane.Axis().Direction().XYZ(), location = plane.Location().XYZ();
  constexpr double same = 1e-12;
  PlaneFrame frame;
  if (std::abs(normal.X()) < same && std::abs(normal.Y()) < same) {
    frame.origin = {0, 0, location.Z()};
  } else if (std::abs(normal.Y()) < same && std::abs(normal.Z()) < same) {
    frame = {{location.X(), 0, 0}, {0, 1, 0}, {0, 0, 1}};
  } else if (std::abs(normal.X()) < same && std::abs(normal.Z()) < same) {
    frame = {{0, location.Y(), 0}, {1, 0, 0}, {0, 0, 1}};
  } else {
    const gp_XYZ x = plane.XAxis().Direction().XYZ();
    frame = {numbers(location), numbers(x), numbers(normal.Crossed(x))};
  }
  return frame;
}

std::string kind_of_surface(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  std::string type = surface.IsNull() ? "no surface" : surface->DynamicType()->Name();
  if (type.rfind("Geom_", 0) == 0) type = type.substr(5);
  return type;
}

// Traverses the wires of one face and converts their edges to NURBS in its plane.
class FaceReader {
 public:
  FaceReader(const OccModel& model, const TopoDS_Face& face, const PlaneFrame& frame, heal::RawFace& raw,
             Report& report)
      : model_(model), face_(face), frame_(frame), raw_(raw), report_(report) {}

  void read() {
    for (TopoDS_Iterator i(face_.Oriented(TopAbs_FORWARD)); i.More(); i.Next()) {
      if (i.Value().ShapeType() == TopAbs_WIRE)
        read_wire(TopoDS::Wire(i.Value()));
      else
        report_.warn(warning::inner_point_ignored, raw_.file + ": ignored a point inside the face");
    }
    const auto stated = model_.num_edges.find(face_.TShape().get());
    if (stated != model_.num_edges.end() && stated->second != num_edges_)
      throw FormatError(fmt::format("{}: the file names {} edges of the face, of which {} can be built", raw_.file,
                                    stated->second, num_edges_));
  }

 private:
  void read_wire(const TopoDS_Wire& wire) {
    std::vector<heal::RawEdge> edges;
    if (wire.Orientation() == TopAbs_INTERNAL || wire.Orientation() == TopAbs_EXTERNAL)
      throw FormatError(fmt::format("{}: the face has an inner wire that bounds nothing", raw_.file));
    for (TopoDS_Iterator i(wire.Oriented(TopAbs_FORWARD)); i.More(); i.Next()) {
      if (i.Value().ShapeType() != TopAbs_EDGE) continue;
      const TopoDS_Edge edge = TopoDS::Edge(i.Value());
      if (!BRep_Tool::Degenerated(edge)) edges.push_back(read_edge(edge));
      ++num_edges_;
    }
    if (edges.empty()) throw FormatError(raw_.file + ": a wire of the face has no edges");
    raw_.wires.push_back(std::move(edges));
  }

  heal::RawEdge read_edge(const TopoDS_Edge& edge) {
    double first = 0, last = 0;
    Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull() && BRepLib::BuildCurve3d(edge)) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) throw FormatError(fmt::format("{}: edge {} has no curve", raw_.file, num_edges_));
    require_plain(edge, *curve, first);

    heal::RawEdge result;
    result.cad_edge = num_edges_;
    const ShapeLabel label = model_.label_of(edge);
    result.name = label.name, result.layer = label.layer, result.colour = label.colour;
    PlaneCurve plane;
    try {
      plane = plane_curve(curve, first, last, frame_, raw_.tolerance / 100);
    } catch (const FormatError& e) {
      throw FormatError(fmt::format("{}: edge {}: {}", raw_.file, num_edges_, e.what()));
    }
    result.height = plane.height;
    if (plane.error > raw_.tolerance / 10)
      report_.warn(warning::edge_approximated,
                   fmt::format("{}: edge {} has no exact rational form and was approximated to {:.3g}", raw_.file,
                               num_edges_, plane.error));
    const bool backwards = edge.Orientation() == TopAbs_REVERSED;
    result.curve = backwards ? curve::reversed(plane.curve) : plane.curve;
    result.start = vertex(TopExp::FirstVertex(edge, true), result.curve.poles.front());
    result.end = vertex(TopExp::LastVertex(edge, true), result.curve.poles.back());
    raw_.shape_tolerance = std::max(raw_.shape_tolerance, BRep_Tool::Tolerance(edge));
    return result;
  }

  // Refuses edges that bound no area: internal edges, and edges with the face on both sides.
  void require_plain(const TopoDS_Edge& edge, const Geom_Curve& curve, double first) {
    const auto same = [&](const TopoDS_Edge& e) { return e.IsSame(edge); };
    const bool inner = edge.Orientation() == TopAbs_INTERNAL || edge.Orientation() == TopAbs_EXTERNAL;
    if (inner || std::any_of(seen_.begin(), seen_.end(), same)) {
      const Vec2 at = frame_.position(curve.Value(first));
      throw FormatError(fmt::format("{}: the face has an inner curve: edge {} at {} has the face on both sides",
                                    raw_.file, num_edges_, position_text(at)));
    }
    seen_.push_back(edge);
  }

  Vec2 vertex(const TopoDS_Vertex& v, Vec2 otherwise) {
    if (v.IsNull()) return otherwise;
    raw_.shape_tolerance = std::max(raw_.shape_tolerance, BRep_Tool::Tolerance(v));
    return frame_.position(BRep_Tool::Pnt(v));
  }

  const OccModel& model_;
  TopoDS_Face face_;
  const PlaneFrame& frame_;
  heal::RawFace& raw_;
  Report& report_;
  std::vector<TopoDS_Edge> seen_;
  int num_edges_ = 0;
};

// Whether the shape is a part of one of the faces.
bool belongs_to(const TopoDS_Shape& shape, const std::vector<FaceChoice>& faces) {
  for (const FaceChoice& choice : faces)
    for (TopExp_Explorer part(choice.face, shape.ShapeType()); part.More(); part.Next())
      if (part.Current().IsSame(shape)) return true;
  return false;
}

void warn_of_construction(const TopoDS_Shape& shape, const std::vector<FaceChoice>& faces, const std::string& file,
                          Report& report) {
  int curves = 0, points = 0;
  for (TopExp_Explorer e(shape, TopAbs_EDGE, TopAbs_FACE); e.More(); e.Next())
    curves += !belongs_to(e.Current(), faces);
  for (TopExp_Explorer e(shape, TopAbs_VERTEX, TopAbs_EDGE); e.More(); e.Next())
    points += !belongs_to(e.Current(), faces);
  const auto warn = [&](const char* code, int count, const std::string& what) {
    if (count > 0)
      report.warn(code, fmt::format("{}: ignored {} {}{} beside the face", file, count, what, count == 1 ? "" : "s"));
  };
  warn(warning::curves_ignored, curves, "curve");
  warn(warning::points_ignored, points, "point");
}

// Under a scaled placement the kernel keeps the parameters of curves, and with them the old ends of lines.
void require_unscaled(const TopoDS_Face& face, const std::string& file) {
  for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
    const double scale = e.Current().Location().Transformation().ScaleFactor();
    if (!(std::abs(std::abs(scale) - 1) < 1e-9))
      throw FormatError(
          fmt::format("{}: the face is placed with a scale of {:.6g}: export it with its own geometry, or "
                      "only rotated, mirrored and moved",
                      file, std::abs(scale)));
  }
}

heal::RawFace raw_face(const OccModel& model, const TopoDS_Face& face, const PlaneFrame& frame, const std::string& file,
                       Report& report) {
  require_unscaled(face, file);
  heal::RawFace raw;
  raw.file = file;
  const ShapeLabel label = model.label_of(face);
  raw.name = label.name, raw.layer = label.layer;
  raw.length_unit = model.length_unit;
  raw.metres_per_unit = model.metres_per_unit;
  raw.tolerance = model.tolerance;
  raw.shape_tolerance = BRep_Tool::Tolerance(face);
  raw.plane_origin = frame.origin;
  raw.plane_x = frame.e_x;
  raw.plane_y = frame.e_y;
  FaceReader(model, face, frame, raw, report).read();
  return raw;
}

}  // namespace

std::optional<gp_Pln> plane_of(const TopoDS_Face& face) {
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull()) return std::nullopt;
  if (const auto trim = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface); !trim.IsNull())
    surface = trim->BasisSurface();
  if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull()) return plane->Pln();
  const GeomLib_IsPlanarSurface planar(surface, 1e-9);
  if (planar.IsPlanar()) return planar.Plan();
  return std::nullopt;
}

std::vector<heal::RawFace> occ_faces(const OccModel& model, const std::vector<FaceChoice>& faces,
                                     const std::string& file, Report& report) {
  const auto plane = plane_of(faces.front().face);
  if (!plane)
    throw FormatError(fmt::format("{}: the face is not planar ({})", file, kind_of_surface(faces.front().face)));
  const PlaneFrame frame = frame_of(*plane);
  std::vector<heal::RawFace> raws;
  for (const FaceChoice& choice : faces) raws.push_back(raw_face(model, choice.face, frame, file, report));
  warn_of_construction(model.shape, faces, file, report);
  return raws;
}

}  // namespace quadrille::occ
