#include "occ/occ_shared_edges.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>

#include "occ/occ_space_edges.hpp"

namespace quadrille::occ {

namespace {

constexpr int num_pieces = 8;

/// Replaces parts of each face by known ones: those of the faces before it and, if they are edges, those of the face
/// itself. `replacement`: of a part, as it is oriented forward, by a known one; null: none.
template <class Replacement>
void replace_parts(std::vector<TopoDS_Face>& faces, TopAbs_ShapeEnum kind, const Replacement& replacement) {
  TopTools_IndexedMapOfShape known;
  for (TopoDS_Face& face : faces) {
    const Handle(BRepTools_ReShape) reshape = new BRepTools_ReShape;
    TopTools_IndexedMapOfShape own, taken;
    TopExp::MapShapes(face, kind, own);
    for (int i = 1; i <= own.Extent(); ++i) {
      const TopoDS_Shape part = own(i).Oriented(TopAbs_FORWARD);
      if (known.Contains(part)) continue;
      TopoDS_Shape other;
      for (int k = 1; k <= known.Extent() && other.IsNull(); ++k) {
        if (kind == TopAbs_VERTEX && (own.Contains(known(k)) || taken.Contains(known(k)))) continue;
        other = replacement(part, known(k).Oriented(TopAbs_FORWARD));
      }
      if (!other.IsNull()) reshape->Replace(part, other), taken.Add(other);
      if (other.IsNull() && kind == TopAbs_EDGE) known.Add(part);
    }
    face = TopoDS::Face(reshape->Apply(face));
    TopExp::MapShapes(face, kind, known);
  }
}

TopoDS_Shape same_vertex(const TopoDS_Shape& part, const TopoDS_Shape& known, double tolerance) {
  const TopoDS_Vertex v = TopoDS::Vertex(part), w = TopoDS::Vertex(known);
  const double apart = BRep_Tool::Pnt(v).Distance(BRep_Tool::Pnt(w));
  if (apart > tolerance) return {};
  BRep_Builder().UpdateVertex(w, apart + BRep_Tool::Tolerance(v));
  return known;
}

/// Whether the first lies along the second, within the tolerance.
bool lies_along(const TopoDS_Edge& edge, const TopoDS_Edge& other, double tolerance) {
  require_curve(other);
  double begin = 0, end = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(other, begin, end);
  if (curve.IsNull()) return false;
  const BRepAdaptor_Curve samples(edge);
  const double first = samples.FirstParameter(), last = samples.LastParameter();
  for (int i = 1; i < num_pieces; ++i) {
    const GeomAPI_ProjectPointOnCurve foot(samples.Value(first + (last - first) * i / num_pieces), curve, begin, end);
    if (foot.NbPoints() == 0 || foot.LowerDistance() > tolerance) return false;
  }
  return true;
}

gp_Vec tangent_in_the_middle(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  gp_Pnt p;
  gp_Vec tangent;
  curve.D1((curve.FirstParameter() + curve.LastParameter()) / 2, p, tangent);
  return tangent;
}

TopoDS_Shape same_edge(const TopoDS_Shape& part, const TopoDS_Shape& known, double tolerance) {
  const TopoDS_Edge e = TopoDS::Edge(part), other = TopoDS::Edge(known);
  if (BRep_Tool::Degenerated(e) || BRep_Tool::Degenerated(other)) return {};
  const TopoDS_Vertex a = TopExp::FirstVertex(e), b = TopExp::LastVertex(e), c = TopExp::FirstVertex(other),
                      d = TopExp::LastVertex(other);
  const bool is_along = a.IsSame(c) && b.IsSame(d), is_against = a.IsSame(d) && b.IsSame(c);
  if (!(is_along || is_against) || !lies_along(e, other, tolerance)) return {};
  const bool is_closed = is_along && is_against;
  const bool is_turned = is_closed ? tangent_in_the_middle(e).Dot(tangent_in_the_middle(other)) < 0 : is_against;
  return known.Oriented(is_turned ? TopAbs_REVERSED : TopAbs_FORWARD);
}

std::vector<TopoDS_Edge> edges_in_order(const TopoDS_Shape& wire) {
  std::vector<TopoDS_Edge> edges;
  for (TopoDS_Iterator e(wire); e.More(); e.Next())
    if (e.Value().ShapeType() == TopAbs_EDGE) edges.push_back(TopoDS::Edge(e.Value()));
  return edges;
}

}  // namespace

TopoDS_Face with_shared_vertices(const TopoDS_Face& face, double tolerance) {
  const Handle(BRepTools_ReShape) reshape = new BRepTools_ReShape;
  for (TopoDS_Iterator wire(face); wire.More(); wire.Next()) {
    const std::vector<TopoDS_Edge> edges = edges_in_order(wire.Value());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const TopoDS_Vertex end = TopExp::LastVertex(edges[i], true),
                          start = TopExp::FirstVertex(edges[(i + 1) % edges.size()], true);
      if (end.IsNull() || start.IsNull() || end.IsSame(start) || same_vertex(start, end, tolerance).IsNull()) continue;
      reshape->Replace(start.Oriented(TopAbs_FORWARD), end.Oriented(TopAbs_FORWARD));
    }
  }
  return TopoDS::Face(reshape->Apply(face));
}

std::vector<TopoDS_Face> with_shared_edges(std::vector<TopoDS_Face> faces, double tolerance) {
  replace_parts(faces, TopAbs_VERTEX, [&](const TopoDS_Shape& part, const TopoDS_Shape& known) {
    return same_vertex(part, known, tolerance);
  });
  replace_parts(faces, TopAbs_EDGE,
                [&](const TopoDS_Shape& part, const TopoDS_Shape& known) { return same_edge(part, known, tolerance); });
  return faces;
}

}  // namespace quadrille::occ
