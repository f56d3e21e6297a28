#include "occ/occ_united_face.hpp"

#include <fmt/format.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "occ/occ_completed_face.hpp"
#include "occ/occ_one_surface.hpp"
#include "occ/occ_shared_edges.hpp"
#include "occ/occ_space_edges.hpp"
#include "occ/occ_surface.hpp"
#include "sew/one_sheet.hpp"

namespace quadrille::occ {

namespace {

/// The material of a face beside an edge: on its left, on its right, or on both sides, seen against the normal of the
/// surface of the first face.
enum class Side { left, right, both };

struct EdgeUse {
  int face = 0;
  Side side = Side::left;
};

struct UsedEdge {
  LabelledEdge labelled;
  std::vector<EdgeUse> uses;

  int count(Side side) const {
    return static_cast<int>(std::count_if(uses.begin(), uses.end(), [&](const EdgeUse& u) { return u.side == side; }));
  }
};

Vec3 middle_of(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  const gp_Pnt p = curve.Value((curve.FirstParameter() + curve.LastParameter()) / 2);
  return {p.X(), p.Y(), p.Z()};
}

std::string text_of(const OccModel& model, const std::vector<FaceChoice>& choices, int f) {
  const std::string name = model.label_of(choices[f].face).name;
  return fmt::format("face {}{}", choices[f].number, name.empty() ? "" : " '" + name + "'");
}

/// The edges of all faces, each once.
class EdgeCollector {
 public:
  explicit EdgeCollector(const OccModel& model) : model_(model) {}

  /// `drawn`: the same face as the file has it, with its labels.
  void add(const TopoDS_Face& face, const TopoDS_Face& drawn, int f, bool is_turned) {
    const std::vector<PlacedEdge> own = edges_of(face), labelled = edges_of(drawn);
    for (std::size_t i = 0; i < own.size(); ++i, ++number_) {
      const auto& [edge, is_inner] = own[i];
      if (BRep_Tool::Degenerated(edge)) continue;
      UsedEdge& used = of(edge, labelled[i].edge);
      used.uses.push_back({f, is_inner ? Side::both : side(edge, is_turned)});
      if (used.labelled.labels.name.empty()) used.labelled.labels.name = model_.label_of(labelled[i].edge).name;
    }
  }

  std::vector<UsedEdge> edges;

 private:
  struct PlacedEdge {
    TopoDS_Edge edge;
    bool is_inner = false;
  };

  static std::vector<PlacedEdge> edges_of(const TopoDS_Face& face) {
    std::vector<PlacedEdge> edges;
    for (TopoDS_Iterator wire(face.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next()) {
      if (wire.Value().ShapeType() != TopAbs_WIRE) continue;
      const bool is_inner = has_face_on_both_sides(wire.Value());
      for (TopoDS_Iterator e(wire.Value()); e.More(); e.Next())
        if (e.Value().ShapeType() == TopAbs_EDGE)
          edges.push_back({TopoDS::Edge(e.Value()), is_inner || has_face_on_both_sides(e.Value())});
    }
    return edges;
  }

  static Side side(const TopoDS_Edge& edge, bool is_turned) {
    return (edge.Orientation() == TopAbs_REVERSED) != is_turned ? Side::right : Side::left;
  }

  UsedEdge& of(const TopoDS_Edge& edge, const TopoDS_Edge& labelled) {
    const int before = numbers_.Extent(), at = numbers_.Add(edge) - 1;
    if (at == before)
      edges.push_back({{TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), labels_of(model_, labelled, number_)}, {}});
    return edges[at];
  }

  const OccModel& model_;
  TopTools_IndexedMapOfShape numbers_;
  int number_ = 0;
};

/// The direction in which the surface of the face closes along the edge, as on a seam.
enum class Closing { none, u, v };

Closing closing_along(const TopoDS_Edge& edge, const Handle(Geom_Surface) & surface) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  const Handle(ShapeAnalysis_Surface) analysis = new ShapeAnalysis_Surface(surface);
  const BRepAdaptor_Curve curve(edge);
  bool is_u = surface->IsUClosed(), is_v = surface->IsVClosed();
  for (const double part : {0.2, 0.5, 0.7}) {
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    const gp_Pnt2d uv = analysis->ValueOfUV(curve.Value(first + part * (last - first)), 0);
    const auto is_near = [&](double t, double begin, double end) {
      const double turns = (t - begin) / (end - begin);
      return std::abs(turns - std::round(turns)) < tolerance::same_point;
    };
    is_u = is_u && is_near(uv.X(), u0, u1), is_v = is_v && is_near(uv.Y(), v0, v1);
  }
  return is_u ? Closing::u : is_v ? Closing::v : Closing::none;
}

bool goes_round(const TopoDS_Face& face, Closing direction) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0, a = 0, b = 0, c = 0, d = 0;
  BRep_Tool::Surface(face)->Bounds(u0, u1, v0, v1);
  BRepTools::UVBounds(face, a, b, c, d);
  return direction == Closing::u ? b - a > (u1 - u0) * (1 - tolerance::same_point)
                                 : d - c > (v1 - v0) * (1 - tolerance::same_point);
}

/// The faces and the edges that bound them, as long as it is not known which of the others are seams.
class Uniter {
 public:
  Uniter(const OccModel& model, const std::vector<FaceChoice>& choices, const std::string& file, double tolerance)
      : model_(model),
        choices_(choices),
        file_(file),
        tolerance_(tolerance),
        first_(TopoDS::Face(choices.front().face.Oriented(TopAbs_FORWARD))) {}

  UnitedFace united() {
    std::vector<TopoDS_Face> faces;
    for (int f = 0; f < num_faces(); ++f) {
      if (f > 0) require_same_surface(f);
      faces.push_back(with_shared_vertices(TopoDS::Face(choices_[f].face.Oriented(TopAbs_FORWARD)), tolerance_));
    }
    faces = with_shared_edges(std::move(faces), tolerance_);
    first_ = faces.front();
    EdgeCollector collector(model_);
    for (int f = 0; f < num_faces(); ++f)
      collector.add(faces[f], choices_[f].face, f, f > 0 && has_opposite_normal(faces[f], first_));
    for (UsedEdge& edge : collector.edges) sort(edge);
    require_connected();
    if (num_faces() == 1 && result_.inner.empty() && are_seams(*this)) return as_it_is(collector.edges);
    result_.face = completed(bounded(result_.outer), file_);
    for (LabelledEdge& edge : doubled_)
      if (!is_seam(edge, result_.face)) result_.inner.push_back(std::move(edge));
    return std::move(result_);
  }

 private:
  int num_faces() const { return static_cast<int>(choices_.size()); }
  std::string pair_text(int a, int b) const {
    return text_of(model_, choices_, a) + " and " + text_of(model_, choices_, b);
  }

  void require_same_surface(int f) const {
    const SurfaceGap gap = gap_from_surface(choices_[f].face, first_);
    if (gap.distance <= same_surface_tolerance(first_, model_.tolerance)) return;
    throw FormatError(fmt::format(
        "{}: {} lie on different surfaces: the second is up to {:.3g} off the surface of the first, at {}: only faces "
        "of one surface are meshed together: mesh these one by one, or {}",
        file_, pair_text(0, f), gap.distance, position_text(gap.position), sew::face_choice_text));
  }

  void sort(UsedEdge& edge) {
    LabelledEdge& labelled = edge.labelled;
    const int left = edge.count(Side::left), right = edge.count(Side::right), face = edge.uses.front().face;
    if (left > 1 || right > 1 || (edge.count(Side::both) > 0 && left + right > 0))
      throw FormatError(fmt::format("{}: {} overlap beside their common edge {} at {}: draw them side by side, or {}",
                                    file_, pair_text(face, edge.uses.back().face), labelled.labels.cad_edge,
                                    position_text(middle_of(labelled.edge)), sew::face_choice_text));
    labelled.faces = {-1, -1};
    for (const EdgeUse& use : edge.uses) {
      if (use.side != Side::right) labelled.faces[0] = use.face;
      if (use.side != Side::left) labelled.faces[1] = use.face;
    }
    if (labelled.faces[0] < 0 || labelled.faces[1] < 0)
      result_.outer.push_back(labelled);
    else if (edge.count(Side::both) == 0 && labelled.faces[0] == labelled.faces[1])
      doubled_.push_back(labelled);
    else
      result_.inner.push_back(labelled);
  }

  void require_connected() const {
    DisjointSets parts(choices_.size());
    for (const LabelledEdge& edge : result_.inner) parts.unite(edge.faces[0], edge.faces[1]);
    for (int f = 1; f < num_faces(); ++f) {
      if (parts.find(f) == parts.find(0)) continue;
      const BRepExtrema_DistShapeShape nearest(own_copy(parts.find(0)), own_copy(f));
      const gp_Pnt p = nearest.PointOnShape1(1);
      const std::string place = position_text(Vec3{p.X(), p.Y(), p.Z()});
      const bool is_apart = nearest.Value() > same_surface_tolerance(first_, model_.tolerance);
      throw FormatError(fmt::format(
          "{}: {} share no edge: {}: join them in the CAD program, such as in one shell, or {}", file_, pair_text(0, f),
          is_apart ? fmt::format("they are {:.3g} apart, nearest at {}", nearest.Value(), place)
                   : "they overlap, or only touch, at " + place,
          sew::face_choice_text));
    }
  }

  /// Completed, which changes edges.
  TopoDS_Shape own_copy(int f) const {
    return completed(TopoDS::Face(BRepBuilderAPI_Copy(choices_[f].face.Oriented(TopAbs_FORWARD)).Shape()), file_);
  }

  /// The first face's surface within these edges, not completed.
  TopoDS_Face bounded(const std::vector<LabelledEdge>& edges) const {
    TopoDS_Face face = TopoDS::Face(first_.EmptyCopied());
    std::vector<TopoDS_Edge> rest;
    for (const LabelledEdge& e : edges)
      rest.push_back(TopoDS::Edge(e.edge.Oriented(e.faces[0] >= 0 ? TopAbs_FORWARD : TopAbs_REVERSED)));
    const BRep_Builder builder;
    while (!rest.empty()) builder.Add(face, next_wire(rest));
    return face;
  }

  TopoDS_Wire next_wire(std::vector<TopoDS_Edge>& rest) const {
    const BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    const TopoDS_Vertex begin = TopExp::FirstVertex(rest.front(), true);
    for (auto next = rest.begin();;) {
      const TopoDS_Vertex end = TopExp::LastVertex(*next, true);
      const Vec3 place = middle_of(*next);
      builder.Add(wire, *next);
      rest.erase(next);
      if (end.IsSame(begin)) break;
      next = std::find_if(rest.begin(), rest.end(),
                          [&](const TopoDS_Edge& e) { return TopExp::FirstVertex(e, true).IsSame(end); });
      if (next == rest.end())
        throw FormatError(
            fmt::format("{}: the edges of the boundary do not meet beside {}: join them in the CAD program", file_,
                        position_text(place)));
    }
    wire.Closed(true);
    return wire;
  }

  bool is_seam(const LabelledEdge& edge, const TopoDS_Face& whole) const {
    const Closing closing = closing_along(edge.edge, BRep_Tool::Surface(TopoDS::Face(choices_[edge.faces[0]].face)));
    return closing != Closing::none && goes_round(whole, closing);
  }

  /// Whether all edges that a single face has twice are seams. Of a copy, as completing a face changes its edges.
  static bool are_seams(const Uniter& of) {
    if (of.doubled_.empty() || of.result_.outer.empty()) return true;
    TopoDS_Face copy = TopoDS::Face(BRepBuilderAPI_Copy(of.bounded(of.result_.outer)).Shape());
    copy = completed(copy, of.file_);
    return std::all_of(of.doubled_.begin(), of.doubled_.end(),
                       [&](const LabelledEdge& e) { return of.is_seam(e, copy); });
  }

  UnitedFace as_it_is(const std::vector<UsedEdge>& edges) const {
    UnitedFace result{completed(first_, file_), {}, {}};
    for (const UsedEdge& edge : edges) result.outer.push_back(edge.labelled);
    return result;
  }

  const OccModel& model_;
  const std::vector<FaceChoice>& choices_;
  const std::string& file_;
  double tolerance_;
  TopoDS_Face first_;
  UnitedFace result_;
  std::vector<LabelledEdge> doubled_;  ///< which one face has twice: seams and cracks
};

}  // namespace

UnitedFace united_face(const OccModel& model, const std::vector<FaceChoice>& choices, const std::string& file,
                       double tolerance) {
  return Uniter(model, choices, file, tolerance).united();
}

}  // namespace quadrille::occ
