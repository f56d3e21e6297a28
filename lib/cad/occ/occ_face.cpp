#include "occ/occ_face.hpp"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "curve/nurbs.hpp"
#include "occ/occ_curves.hpp"
#include "occ/occ_parts_beside.hpp"

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

// Converts edges to NURBS in the plane of a face.
class EdgeReader {
 public:
  EdgeReader(const OccModel& model, const PlaneFrame& frame, heal::RawFace& raw, Report& report)
      : model_(model), frame_(frame), raw_(raw), report_(report) {}

  heal::RawEdge read(const TopoDS_Edge& edge, int number) {
    double first = 0, last = 0;
    Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull() && BRepLib::BuildCurve3d(edge)) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) throw FormatError(fmt::format("{}: edge {} has no curve", raw_.file, number));
    if (Precision::IsInfinite(first) || Precision::IsInfinite(last))
      throw FormatError(fmt::format("{}: edge {} is infinite", raw_.file, number));

    heal::RawEdge result;
    result.cad_edge = number;
    const ShapeLabel label = model_.label_of(edge);
    result.name = label.name, result.layer = label.layer, result.colour = label.colour;
    PlaneCurve plane;
    try {
      plane = plane_curve(curve, first, last, frame_, raw_.tolerance / 100);
    } catch (const FormatError& e) {
      throw FormatError(fmt::format("{}: edge {}: {}", raw_.file, number, e.what()));
    }
    result.height = plane.height;
    if (plane.error > raw_.tolerance / 10)
      report_.warn(warning::edge_approximated,
                   fmt::format("{}: edge {} has no exact rational form and was approximated to {:.3g}", raw_.file,
                               number, plane.error));
    const bool backwards = edge.Orientation() == TopAbs_REVERSED;
    result.curve = backwards ? curve::reversed(plane.curve) : plane.curve;
    result.start = vertex(TopExp::FirstVertex(edge, true), result.curve.poles.front());
    result.end = vertex(TopExp::LastVertex(edge, true), result.curve.poles.back());
    raw_.shape_tolerance = std::max(raw_.shape_tolerance, BRep_Tool::Tolerance(edge));
    return result;
  }

 private:
  Vec2 vertex(const TopoDS_Vertex& v, Vec2 otherwise) {
    if (v.IsNull()) return otherwise;
    raw_.shape_tolerance = std::max(raw_.shape_tolerance, BRep_Tool::Tolerance(v));
    return frame_.position(BRep_Tool::Pnt(v));
  }

  const OccModel& model_;
  const PlaneFrame& frame_;
  heal::RawFace& raw_;
  Report& report_;
};

// Traverses the wires of one face.
class FaceReader {
 public:
  FaceReader(const OccModel& model, const TopoDS_Face& face, const PlaneFrame& frame, heal::RawFace& raw,
             Report& report)
      : model_(model), face_(face), raw_(raw), report_(report), edge_reader_(model, frame, raw, report) {}

  void read() {
    for (TopExp_Explorer e(face_, TopAbs_EDGE); e.More(); e.Next()) {
      const int number = number_of(e.Current());
      ++uses_[number];
    }
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
    const bool is_inner = has_face_on_both_sides(wire);
    std::vector<heal::RawEdge> edges;
    bool has_any = false, was_divided = false;
    for (TopoDS_Iterator i(wire.Oriented(TopAbs_FORWARD)); i.More(); i.Next()) {
      if (i.Value().ShapeType() != TopAbs_EDGE) continue;
      const TopoDS_Edge edge = TopoDS::Edge(i.Value());
      if (!BRep_Tool::Degenerated(edge)) {
        has_any = true;
        if (is_inner || has_face_on_both_sides(edge) || uses_[number_of(edge)] > 1)
          read_inner(edge), was_divided = true;
        else
          edges.push_back(edge_reader_.read(edge, num_edges_));
      }
      ++num_edges_;
    }
    if (!has_any) throw FormatError(raw_.file + ": a wire of the face has no edges");
    if (was_divided)
      add_chains(std::move(edges));
    else
      raw_.wires.push_back(std::move(edges));
  }

  // An edge that a wire has twice, forth and back, is one curve.
  void read_inner(const TopoDS_Edge& edge) {
    const int index = number_of(edge);
    if (std::find(inner_.begin(), inner_.end(), index) != inner_.end()) return;
    inner_.push_back(index);
    raw_.inner_edges.push_back(edge_reader_.read(edge, num_edges_));
  }

  // What is left of a wire without its inner edges may be several closed chains.
  void add_chains(std::vector<heal::RawEdge> rest) {
    while (!rest.empty()) {
      std::vector<heal::RawEdge> chain{std::move(rest.front())};
      rest.erase(rest.begin());
      for (double gap = distance(chain.back().end, chain.front().start); !rest.empty();) {
        const auto next = std::min_element(rest.begin(), rest.end(), [&](const auto& a, const auto& b) {
          return distance(chain.back().end, a.start) < distance(chain.back().end, b.start);
        });
        if (gap <= distance(chain.back().end, next->start)) break;
        chain.push_back(std::move(*next));
        rest.erase(next);
        gap = distance(chain.back().end, chain.front().start);
      }
      raw_.wires.push_back(std::move(chain));
    }
  }

  // The number of the edge, whatever its orientation.
  int number_of(const TopoDS_Shape& edge) {
    const int number = edges_.Add(edge) - 1;
    if (number >= static_cast<int>(uses_.size())) uses_.push_back(0);
    return number;
  }

  const OccModel& model_;
  TopoDS_Face face_;
  heal::RawFace& raw_;
  Report& report_;
  EdgeReader edge_reader_;
  TopTools_IndexedMapOfShape edges_;
  std::vector<int> uses_;   // by the wires
  std::vector<int> inner_;  // those that are read
  int num_edges_ = 0;
};

// Those that have a curve of use; infinite lines, for example, have none.
std::vector<heal::RawEdge> free_edges(const OccModel& model, const std::vector<TopoDS_Shape>& edges,
                                      const PlaneFrame& frame, heal::RawFace raw, Report& report) {
  std::vector<heal::RawEdge> result;
  EdgeReader reader(model, frame, raw, report);
  for (const TopoDS_Shape& edge : edges) {
    try {
      result.push_back(reader.read(TopoDS::Edge(edge), static_cast<int>(result.size())));
    } catch (const FormatError&) {  // counted by the caller
    }
  }
  return result;
}

std::vector<TopoDS_Face> shapes_of(const std::vector<FaceChoice>& choices) {
  std::vector<TopoDS_Face> faces;
  for (const FaceChoice& choice : choices) faces.push_back(choice.face);
  return faces;
}

/// Without edges.
heal::RawFace blank_face(const OccModel& model, const PlaneFrame& frame, const std::string& file) {
  heal::RawFace raw;
  raw.file = file;
  raw.length_unit = model.length_unit;
  raw.metres_per_unit = model.metres_per_unit;
  raw.tolerance = model.tolerance;
  raw.plane_origin = frame.origin;
  raw.plane_x = frame.e_x;
  raw.plane_y = frame.e_y;
  return raw;
}

heal::RawFace raw_face(const OccModel& model, const TopoDS_Face& face, const PlaneFrame& frame, const std::string& file,
                       Report& report) {
  require_unscaled(face, file);
  heal::RawFace raw = labels_of_face(model, face, file);
  raw.plane_origin = frame.origin;
  raw.plane_x = frame.e_x;
  raw.plane_y = frame.e_y;
  FaceReader(model, face, frame, raw, report).read();
  return raw;
}

/// Of each finite edge.
std::vector<gp_Pnt> samples_of(const std::vector<TopoDS_Shape>& edges) {
  std::vector<gp_Pnt> samples;
  for (const TopoDS_Shape& edge : edges) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edge));
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) continue;
    for (int i = 0; i <= 8; ++i) samples.push_back(curve.Value(first + (last - first) * i / 8));
  }
  return samples;
}

/// Through the first point, the one farthest from it, and the one farthest from their line.
gp_Pln plane_through(const std::vector<gp_Pnt>& points, const std::string& file) {
  if (points.empty()) throw FormatError(file + ": the file holds no face; expected one planar face");
  const gp_Pnt origin = points.front();
  const auto farthest = [&](const auto& distance) {
    return *std::max_element(points.begin(), points.end(),
                             [&](const gp_Pnt& a, const gp_Pnt& b) { return distance(a) < distance(b); });
  };
  const gp_Vec along(origin, farthest([&](const gp_Pnt& p) { return origin.Distance(p); }));
  const gp_Vec across(origin,
                      farthest([&](const gp_Pnt& p) { return along.Crossed(gp_Vec(origin, p)).SquareMagnitude(); }));
  const gp_Vec normal = along.Crossed(across);
  if (!(normal.Magnitude() > 1e-9 * along.SquareMagnitude()))
    throw FormatError(file + ": the file holds no face, and its curves lie on one line");
  return {origin, gp_Dir(normal)};
}

}  // namespace

bool has_face_on_both_sides(const TopoDS_Shape& shape) {
  return shape.Orientation() == TopAbs_INTERNAL || shape.Orientation() == TopAbs_EXTERNAL;
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

heal::RawFace labels_of_face(const OccModel& model, const TopoDS_Face& face, const std::string& file) {
  heal::RawFace raw = blank_face(model, PlaneFrame(), file);
  const ShapeLabel label = model.label_of(face);
  raw.name = label.name, raw.layer = label.layer;
  raw.shape_tolerance = BRep_Tool::Tolerance(face);
  return raw;
}

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

FacesAndEdges occ_faces(const OccModel& model, const std::vector<FaceChoice>& faces, const std::string& file,
                        Report& report) {
  const auto plane = plane_of(faces.front().face);
  if (!plane) throw FormatError(fmt::format("{}: the face is {}", file, not_planar_text(faces)));
  const PlaneFrame frame = frame_of(*plane);
  FacesAndEdges result;
  for (const FaceChoice& choice : faces) {
    result.faces.push_back(raw_face(model, choice.face, frame, file, report));
    result.faces.back().cad_face = choice.number;
  }
  const auto edges = parts_beside(model.shape, TopAbs_EDGE, TopAbs_FACE, shapes_of(faces));
  result.free_edges = free_edges(model, edges, frame, result.faces.front(), report);
  result.num_ignored_curves = static_cast<int>(edges.size() - result.free_edges.size());
  result.num_points = static_cast<int>(parts_beside(model.shape, TopAbs_VERTEX, TopAbs_EDGE, shapes_of(faces)).size());
  return result;
}

FacesAndEdges face_of_curves(const OccModel& model, const std::string& file, Report& report) {
  const auto edges = parts_beside(model.shape, TopAbs_EDGE, TopAbs_FACE, {});
  const PlaneFrame frame = frame_of(plane_through(samples_of(edges), file));
  heal::RawFace raw = blank_face(model, frame, file);
  FacesAndEdges result;
  raw.wires = {free_edges(model, edges, frame, raw, report)};
  result.num_ignored_curves = static_cast<int>(edges.size() - raw.wires.front().size());
  result.num_points = static_cast<int>(parts_beside(model.shape, TopAbs_VERTEX, TopAbs_EDGE, {}).size());
  result.faces = {std::move(raw)};
  return result;
}

void warn_of_ignored(const FacesAndEdges& found, const std::string& file, Report& report) {
  for (const auto& [code, count, what] : {std::tuple{warning::curves_ignored, found.num_ignored_curves, "curve"},
                                          std::tuple{warning::points_ignored, found.num_points, "point"}})
    if (count > 0) report.warn(code, fmt::format("{}: ignored {} beside the face", file, counted(count, what)));
}

}  // namespace quadrille::occ
