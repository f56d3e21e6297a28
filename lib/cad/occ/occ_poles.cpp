#include "occ/occ_poles.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <utility>
#include <vector>

namespace quadrille::occ {

namespace {

struct Pole {
  gp_Pnt position;
  TopoDS_Vertex vertex;
};

std::vector<Pole> poles_of(const TopoDS_Face& face) {
  const Handle(ShapeAnalysis_Surface) surface = new ShapeAnalysis_Surface(BRep_Tool::Surface(face));
  std::vector<Pole> poles;
  for (int i = 1; i <= surface->NbSingularities(Precision::Confusion()); ++i) {
    Pole pole;
    double accuracy = 0, first = 0, last = 0;
    gp_Pnt2d begin, end;
    Standard_Boolean is_u = false;
    surface->Singularity(i, accuracy, pole.position, begin, end, first, last, is_u);
    BRep_Builder().MakeVertex(pole.vertex, pole.position, Precision::Confusion());
    poles.push_back(std::move(pole));
  }
  return poles;
}

/// A vertex inside an edge.
struct Cut {
  double parameter = 0;
  TopoDS_Vertex vertex;
};

std::vector<Cut> cuts_of(const TopoDS_Edge& edge, const std::vector<Pole>& poles) {
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  std::vector<Cut> cuts;
  if (curve.IsNull() || BRep_Tool::Degenerated(edge)) return cuts;
  const double near = std::max(BRep_Tool::Tolerance(edge), Precision::Confusion());
  const auto is_end = [&](const gp_Pnt& p) {
    return p.Distance(curve->Value(first)) <= near || p.Distance(curve->Value(last)) <= near;
  };
  for (const Pole& pole : poles) {
    if (is_end(pole.position)) continue;
    const GeomAPI_ProjectPointOnCurve foot(pole.position, curve, first, last);
    if (foot.NbPoints() > 0 && foot.LowerDistance() <= near)
      cuts.push_back({foot.LowerDistanceParameter(), pole.vertex});
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.parameter < b.parameter; });
  return cuts;
}

/// In the direction of the edge as it is oriented.
std::vector<TopoDS_Edge> parts_of(const TopoDS_Edge& edge, std::vector<Cut> cuts) {
  const auto forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  double first = 0, last = 0;
  BRep_Tool::Range(forward, first, last);
  cuts.insert(cuts.begin(), {first, TopExp::FirstVertex(forward)});
  cuts.push_back({last, TopExp::LastVertex(forward)});
  const BRep_Builder builder;
  std::vector<TopoDS_Edge> parts;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    auto part = TopoDS::Edge(forward.EmptyCopied());
    builder.Add(part, cuts[i - 1].vertex.Oriented(TopAbs_FORWARD));
    builder.Add(part, cuts[i].vertex.Oriented(TopAbs_REVERSED));
    builder.Range(part, cuts[i - 1].parameter, cuts[i].parameter);
    parts.push_back(TopoDS::Edge(part.Oriented(edge.Orientation())));
  }
  if (edge.Orientation() == TopAbs_REVERSED) std::reverse(parts.begin(), parts.end());
  return parts;
}

}  // namespace

TopoDS_Face split_at_poles(const TopoDS_Face& face) {
  const std::vector<Pole> poles = poles_of(face);
  bool is_split = false;
  const BRep_Builder builder;
  auto result = TopoDS::Face(face.EmptyCopied());
  for (TopoDS_Iterator wires(face, false); wires.More(); wires.Next()) {
    if (wires.Value().ShapeType() != TopAbs_WIRE) return face;
    TopoDS_Shape wire = wires.Value().EmptyCopied();
    for (TopoDS_Iterator edges(wires.Value(), false); edges.More(); edges.Next()) {
      const auto edge = TopoDS::Edge(edges.Value());
      const std::vector<Cut> cuts = cuts_of(edge, poles);
      if (cuts.empty()) builder.Add(wire, edge);
      for (const TopoDS_Edge& part : cuts.empty() ? std::vector<TopoDS_Edge>{} : parts_of(edge, cuts))
        builder.Add(wire, part);
      is_split = is_split || !cuts.empty();
    }
    wire.Closed(wires.Value().Closed());
    builder.Add(result, wire);
  }
  return is_split ? result : face;
}

}  // namespace quadrille::occ
