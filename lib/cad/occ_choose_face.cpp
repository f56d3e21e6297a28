#include <fmt/format.h>
#include <fmt/ranges.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <charconv>

#include "base/error.hpp"
#include "cad/occ_face.hpp"

namespace quadrille::cad {
namespace {

std::vector<TopoDS_Face> faces_of(const OccModel& model) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(model.shape, TopAbs_FACE, map);
  std::vector<TopoDS_Face> faces;
  for (int i = 1; i <= map.Extent(); ++i) faces.push_back(TopoDS::Face(map(i)));
  return faces;
}

// In the order of GeomAbs_CurveType and GeomAbs_SurfaceType.
constexpr std::array curve_kinds{"line",   "circle", "ellipse", "hyperbola", "parabola",
                                 "spline", "spline", "offset",  "other"};
constexpr std::array surface_kinds{"plane",  "cylinder",   "cone",      "sphere", "torus", "spline",
                                   "spline", "revolution", "extrusion", "offset", "other"};

std::string kind_of(const TopoDS_Face& face) {
  if (BRep_Tool::Surface(face).IsNull()) return "other";
  return plane_of(face) ? "plane" : surface_kinds.at(BRepAdaptor_Surface(face, false).GetType());
}

std::array<double, 3> numbers(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

// Sets length and place from the curves of `shape`.
void measure(const TopoDS_Shape& shape, ListedShape& listed) {
  GProp_GProps measured;
  BRepGProp::LinearProperties(shape, measured);
  listed.length = measured.Mass(), listed.place = numbers(measured.CentreOfMass());
}

ListedShape listed_edge(const OccModel& model, const TopoDS_Edge& edge) {
  ListedShape listed{model.label_of(edge).name, "point", 0, {}};
  if (BRep_Tool::Degenerated(edge)) return listed;
  const BRepAdaptor_Curve curve(edge);
  listed.kind = curve_kinds.at(curve.GetType());
  measure(edge, listed);
  listed.place = numbers(curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2));
  return listed;
}

ListedFace listed_face(const OccModel& model, const TopoDS_Face& face) {
  ListedFace listed{{model.label_of(face).name, kind_of(face), 0, {}}, {}};
  measure(face, listed.face);
  for (TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next())
    for (TopoDS_Iterator e(wire.Value().Oriented(TopAbs_FORWARD)); e.More(); e.Next())
      if (e.Value().ShapeType() == TopAbs_EDGE) listed.edges.push_back(listed_edge(model, TopoDS::Edge(e.Value())));
  return listed;
}

constexpr const char* how = "--face NUMBER or --face NAME (cad2tri --list FILE shows numbers and names)";

// The message distinguishes connected faces from separate ones: those of a shell share edges.
std::string several(const std::vector<TopoDS_Face>& faces, int stated) {
  TopTools_IndexedMapOfShape edges;
  int uses = 0;
  for (const TopoDS_Face& face : faces)
    for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) ++uses, edges.Add(e.Current());
  const int shared = uses - edges.Extent();
  return fmt::format("several faces ({}{})", stated, shared > 0 ? fmt::format(" with {} shared edges", shared) : "");
}

TopoDS_Face only_face(const OccModel& model, const std::vector<TopoDS_Face>& faces, const std::string& file) {
  const int num_faces = std::max(model.num_faces, static_cast<int>(faces.size()));
  if (num_faces == 1 && model.num_solids == 0) return faces.front();
  const std::string what = model.num_solids > 0 ? "a solid" : several(faces, num_faces);
  throw FormatError(fmt::format("{}: the file holds {}: choose one planar face with {}", file, what, how));
}

// The numbers of the faces that `choice` means.
std::vector<int> chosen(const OccModel& model, const std::vector<TopoDS_Face>& faces, const std::string& choice) {
  std::vector<int> found;
  const int num_faces = static_cast<int>(faces.size());
  for (int i = 0; i < num_faces; ++i)
    if (model.label_of(faces[i]).name == choice) found.push_back(i);
  int number = -1;
  const char* end = choice.data() + choice.size();
  const auto read = std::from_chars(choice.data(), end, number);
  if (found.empty() && read.ec == std::errc() && read.ptr == end && 0 <= number && number < num_faces)
    found.push_back(number);
  return found;
}

}  // namespace

FaceList list_faces(const OccModel& model) {
  FaceList list;
  list.length_unit = model.length_unit;
  for (const TopoDS_Face& face : faces_of(model)) list.faces.push_back(listed_face(model, face));
  return list;
}

TopoDS_Face choose_face(const OccModel& model, const std::string& choice, const std::string& file) {
  const std::vector<TopoDS_Face> faces = faces_of(model);
  if (model.num_faces == 0) throw FormatError(file + ": the file holds no face; expected one planar face");
  if (faces.empty()) throw FormatError(file + ": the face cannot be built from what the file says");
  if (choice.empty()) return only_face(model, faces, file);
  const std::vector<int> found = chosen(model, faces, choice);
  if (found.empty())
    throw FormatError(
        fmt::format("{}: --face {}: no face has this name or number; the file holds {}, numbered from 0: "
                    "choose with {}",
                    file, choice, faces.size(), how));
  if (found.size() > 1)
    throw FormatError(fmt::format("{}: --face {}: the faces {} have this name: choose one by its number", file, choice,
                                  fmt::join(found, ", ")));
  return faces[found.front()];
}

}  // namespace quadrille::cad
