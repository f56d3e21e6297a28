#include <fmt/format.h>
#include <fmt/ranges.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/number_list.hpp"
#include "occ/occ_face.hpp"
#include "occ/occ_one_surface.hpp"
#include "sew/one_sheet.hpp"

namespace quadrille::occ {
namespace {

/// A face at its place, with the parts that hold it.
struct PlacedFace {
  TopoDS_Face face;
  std::vector<std::string> parts;  ///< names of the products, solids and shells around it, outermost first
  std::string layer;               ///< of the face, else of the innermost part that has one

  /// "rig/bolt"
  std::string part_path() const { return fmt::format("{}", fmt::join(parts, "/")); }
};

/// All of an OpenCASCADE model.
class FaceCollector {
 public:
  explicit FaceCollector(const OccModel& model) : model_(model) {}

  void collect(const TopoDS_Shape& shape, PlacedFace around) {
    if (shape.ShapeType() > TopAbs_FACE) return;
    if (shape.ShapeType() == TopAbs_FACE) return add(TopoDS::Face(shape), std::move(around));
    const auto part = model_.parts.find(shape.TShape().get());
    if (part != model_.parts.end()) enter(part->second, around);
    for (TopoDS_Iterator i(shape); i.More(); i.Next()) collect(i.Value(), around);
  }

  std::vector<PlacedFace> faces;

 private:
  // CAD programs give a product and its solid the same name: it is listed once.
  static void enter(const PartLabel& part, PlacedFace& around) {
    for (const std::string& name : part.names)
      if (around.parts.empty() || around.parts.back() != name) around.parts.push_back(name);
    if (!part.layer.empty()) around.layer = part.layer;
  }

  void add(const TopoDS_Face& face, PlacedFace placed) {
    if (!seen_.Add(face)) return;
    const std::string own_layer = model_.label_of(face).layer;
    if (!own_layer.empty()) placed.layer = own_layer;
    placed.face = face;
    faces.push_back(std::move(placed));
  }

  const OccModel& model_;
  TopTools_MapOfShape seen_;  ///< keys: shape and place, without orientation
};

/// In the order of the file. A face that an assembly places several times is found at each place; one that two parts
/// share is found once, in the first of them.
std::vector<PlacedFace> placed_faces(const OccModel& model) {
  FaceCollector collector(model);
  collector.collect(model.shape, {});
  return std::move(collector.faces);
}

// In the order of GeomAbs_CurveType and GeomAbs_SurfaceType.
constexpr std::array curve_kinds{"line",   "circle", "ellipse", "hyperbola", "parabola",
                                 "spline", "spline", "offset",  "other"};
constexpr std::array surface_kinds{"plane",  "cylinder",   "cone",      "sphere", "torus", "spline",
                                   "spline", "revolution", "extrusion", "offset", "other"};

std::array<double, 3> numbers(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

// Sets length and place from the curves of `shape`.
void measure(const TopoDS_Shape& shape, cad::ListedShape& listed) {
  GProp_GProps measured;
  BRepGProp::LinearProperties(shape, measured);
  listed.length = measured.Mass(), listed.place = numbers(measured.CentreOfMass());
}

cad::ListedShape listed_edge(const OccModel& model, const TopoDS_Edge& edge) {
  cad::ListedShape listed{model.label_of(edge).name, "point", 0, {}};
  if (BRep_Tool::Degenerated(edge)) return listed;
  const BRepAdaptor_Curve curve(edge);
  listed.kind = curve_kinds.at(curve.GetType());
  measure(edge, listed);
  listed.place = numbers(curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2));
  return listed;
}

/// "radius 1"
std::string size_of(const TopoDS_Face& face) {
  if (BRep_Tool::Surface(face).IsNull()) return {};
  const BRepAdaptor_Surface surface(face, false);
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
      return fmt::format("radius {:.6g}", surface.Cylinder().Radius());
    case GeomAbs_Sphere:
      return fmt::format("radius {:.6g}", surface.Sphere().Radius());
    case GeomAbs_Cone:
      return fmt::format("half-angle {:.6g} degrees", degrees(std::abs(surface.Cone().SemiAngle())));
    case GeomAbs_Torus:
      return fmt::format("radii {:.6g} and {:.6g}", surface.Torus().MajorRadius(), surface.Torus().MinorRadius());
    default:
      return {};
  }
}

/// Whether all edges are seams and poles.
bool is_closed(const TopoDS_Face& face) {
  for (TopExp_Explorer e(face, TopAbs_EDGE); e.More(); e.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(e.Current());
    if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face)) return false;
  }
  return true;
}

cad::ListedFace listed_face(const OccModel& model, const PlacedFace& placed) {
  const TopoDS_Face& face = placed.face;
  cad::ListedFace listed{{model.label_of(face).name, kind_of(face), 0, {}}, placed.part_path(), placed.layer, {}};
  measure(face, listed.face);
  if (listed.face.kind != "plane") listed.size = size_of(face), listed.is_closed = is_closed(face);
  for (TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next())
    for (TopoDS_Iterator e(wire.Value().Oriented(TopAbs_FORWARD)); e.More(); e.Next())
      if (e.Value().ShapeType() == TopAbs_EDGE) listed.edges.push_back(listed_edge(model, TopoDS::Edge(e.Value())));
  return listed;
}

// The message distinguishes connected faces from separate ones: those of a shell share edges.
std::string several(const std::vector<PlacedFace>& faces, int stated) {
  TopTools_IndexedMapOfShape edges;
  int uses = 0;
  for (const PlacedFace& placed : faces)
    for (TopExp_Explorer e(placed.face, TopAbs_EDGE); e.More(); e.Next()) ++uses, edges.Add(e.Current());
  const int shared = uses - edges.Extent();
  return fmt::format("several faces ({}{})", stated, shared > 0 ? fmt::format(" with {} shared edges", shared) : "");
}

// The name of the innermost part, if not all faces have the same.
std::string part_name(const std::vector<PlacedFace>& faces, const PlacedFace& face) {
  const auto is_alike = [&](const PlacedFace& f) { return f.parts == faces.front().parts; };
  if (face.parts.empty() || std::all_of(faces.begin(), faces.end(), is_alike)) return {};
  return face.parts.back();
}

/// Whether faces can be meant as one: in planes, or on one curved surface.
bool are_together(const OccModel& model, const std::vector<PlacedFace>& faces) {
  const auto is_planar = [](const PlacedFace& f) { return plane_of(f.face).has_value(); };
  if (std::all_of(faces.begin(), faces.end(), is_planar)) return true;
  const TopoDS_Face& first = faces.front().face;
  const double tolerance = same_surface_tolerance(first, model.tolerance);
  return kind_of(first) != "other" && std::all_of(faces.begin() + 1, faces.end(), [&](const PlacedFace& f) {
           return kind_of(f.face) == kind_of(first) && gap_from_surface(f.face, first).distance <= tolerance;
         });
}

std::vector<FaceChoice> all_faces(const OccModel& model, const std::vector<PlacedFace>& faces,
                                  const std::string& file) {
  const int num_faces = std::max(model.num_faces, static_cast<int>(faces.size()));
  if (num_faces == 1 && model.num_solids == 0) return {{faces.front().face, {}, {}}};
  if (model.num_solids > 0 || !model.not_built.empty() || !are_together(model, faces))
    throw FormatError(fmt::format("{}: the file holds {}: {}", file,
                                  model.num_solids > 0 ? "a solid" : several(faces, num_faces), sew::face_choice_text));
  std::vector<FaceChoice> all;
  for (const PlacedFace& placed : faces) {
    FaceChoice& choice = all.emplace_back();
    choice.face = placed.face, choice.part = part_name(faces, placed);
    choice.number = static_cast<int>(all.size()) - 1;
    choice.piece.face = std::to_string(choice.number);
  }
  return all;
}

// The numbers of the faces that fulfil `condition`.
template <class Condition>
std::vector<int> numbers_of(const std::vector<PlacedFace>& faces, Condition condition) {
  std::vector<int> found;
  for (size_t i = 0; i < faces.size(); ++i)
    if (condition(faces[i])) found.push_back(static_cast<int>(i));
  return found;
}

std::optional<int> as_number(const std::string& choice, int num_faces) {
  const std::optional<int> number = quadrille::number_of<int>(choice);
  return number && *number >= 0 && *number < num_faces ? number : std::nullopt;
}

// "cover.1" is piece 1 of the face with the name "cover".
outline::FacePiece piece_of(const std::string& choice) {
  const size_t dot = choice.rfind('.');
  if (dot == std::string::npos) return {choice, -1};
  const auto number = as_number(choice.substr(dot + 1), std::numeric_limits<int>::max());
  return number ? outline::FacePiece{choice.substr(0, dot), *number} : outline::FacePiece{choice, -1};
}

bool is_held_by(const PlacedFace& face, const std::string& name) {
  const auto& parts = face.parts;
  return face.layer == name || face.part_path() == name || std::find(parts.begin(), parts.end(), name) != parts.end();
}

// "; could not be built: #40 'lid'"; empty if all faces could.
std::string not_built(const OccModel& model) {
  return model.not_built.empty() ? std::string()
                                 : fmt::format("; could not be built: {}", fmt::join(model.not_built, ", "));
}

struct Choice {
  std::vector<int> faces;
  const char* relation = "have this name";
};

// The faces that `choice` means. Parts and layers come last, because many of them are named by numbers.
Choice chosen(const OccModel& model, const std::vector<PlacedFace>& faces, const std::string& choice) {
  const auto named = [&](const PlacedFace& f) { return model.label_of(f.face).name == choice; };
  std::vector<int> found = numbers_of(faces, named);
  if (!found.empty()) return {found};
  if (const auto number = as_number(choice, static_cast<int>(faces.size()))) return {{*number}};
  const auto held = [&](const PlacedFace& f) { return is_held_by(f, choice); };
  return {numbers_of(faces, held), "lie in the part or layer of this name"};
}

// "0-3, 7, 8": runs of three or more numbers are shortened.
std::string list_text(const std::vector<int>& numbers) {
  std::vector<std::string> runs;
  for (size_t i = 0; i < numbers.size();) {
    size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    if (end - i < 3) end = i + 1;
    runs.push_back(end == i + 1 ? std::to_string(numbers[i]) : fmt::format("{}-{}", numbers[i], numbers[end - 1]));
    i = end;
  }
  return fmt::format("{}", fmt::join(runs, ", "));
}

}  // namespace

std::string kind_of(const TopoDS_Face& face) {
  if (BRep_Tool::Surface(face).IsNull()) return "other";
  return plane_of(face) ? "plane" : surface_kinds.at(BRepAdaptor_Surface(face, false).GetType());
}

std::string not_planar_text(const std::vector<FaceChoice>& choices) {
  const std::string kind = kind_of(choices.front().face);
  std::string number;
  for (const FaceChoice& choice : choices) number += (number.empty() ? "" : ",") + choice.piece.face;
  if (kind == "other") return "has no surface that can be used";
  const std::string name = kind == "spline" || kind == "revolution" || kind == "extrusion" || kind == "offset"
                               ? fmt::format("not planar (surface of kind {})", kind)
                               : fmt::format("not planar (a {})", kind);
  return fmt::format("{}: cad2chart --face {} makes a chart of it, which cad2tri reads; quadmesh --face {} does both",
                     name, number, number);
}

std::vector<TopoDS_Face> faces_of(const OccModel& model) {
  std::vector<TopoDS_Face> faces;
  for (const PlacedFace& placed : placed_faces(model)) faces.push_back(placed.face);
  return faces;
}

cad::FaceList list_faces(const OccModel& model) {
  cad::FaceList list;
  list.length_unit = model.length_unit;
  for (const PlacedFace& placed : placed_faces(model)) list.faces.push_back(listed_face(model, placed));
  list.not_built = model.not_built;
  return list;
}

namespace {

/// "0,1": several faces as one.
std::vector<FaceChoice> listed_faces(const OccModel& model, const std::string& list, const std::string& file) {
  std::vector<FaceChoice> choices;
  for (size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = list.find(',', begin);
    const std::string item = list.substr(begin, end - begin);
    if (item.empty()) throw FormatError(fmt::format("{}: --face {}: a face is missing between commas", file, list));
    const FaceChoice choice = choose_faces(model, item, file).front();
    if (choice.piece.number >= 0)
      throw FormatError(
          fmt::format("{}: --face {}: a piece of a face is not one of several: give {} alone", file, list, item));
    if (std::ranges::any_of(choices, [&](const FaceChoice& c) { return c.number == choice.number; }))
      throw FormatError(fmt::format("{}: --face {}: face {} is there twice", file, list, choice.number));
    choices.push_back(choice);
  }
  return choices;
}

}  // namespace

std::vector<FaceChoice> choose_faces(const OccModel& model, const std::string& choice, const std::string& file) {
  const std::vector<PlacedFace> faces = placed_faces(model);
  if (model.num_faces == 0) throw FormatError(file + ": the file holds no face; expected one planar face");
  if (faces.empty()) throw FormatError(file + ": the face cannot be built from what the file says" + not_built(model));
  if (choice.empty()) return all_faces(model, faces, file);
  outline::FacePiece piece{choice, -1};
  Choice found = chosen(model, faces, choice);
  if (found.faces.empty() && choice.find(',') != std::string::npos) return listed_faces(model, choice, file);
  if (found.faces.empty()) piece = piece_of(choice), found = chosen(model, faces, piece.face);
  if (found.faces.empty())
    throw FormatError(fmt::format(
        "{}: --face {}: no face has this name or number; the file holds {}, numbered from 0, and no part or "
        "layer of this name{}: {}",
        file, choice, faces.size(), not_built(model), sew::face_choice_text));
  if (found.faces.size() > 1)
    throw FormatError(fmt::format("{}: --face {}: the faces {} {}: choose one by its number", file, choice,
                                  list_text(found.faces), found.relation));
  const int number = found.faces.front();
  return {{faces[number].face, piece, {}, number}};
}

}  // namespace quadrille::occ
