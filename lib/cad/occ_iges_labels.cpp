#include <fmt/format.h>

#include <BRep_Tool.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_CircularArc.hxx>
#include <IGESGeom_CompositeCurve.hxx>
#include <IGESGeom_CurveOnSurface.hxx>
#include <IGESGeom_Line.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESGraph_Color.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TransferBRep.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/name_text.hpp"
#include "cad/occ_labels.hpp"

namespace quadrille::cad {
namespace {

using Entity = Handle(IGESData_IGESEntity);

std::string name_of(const IGESData_IGESEntity& entity) {
  if (entity.NbTypedProperties(STANDARD_TYPE(IGESBasic_Name)) != 1) return {};
  const auto name = Handle(IGESBasic_Name)::DownCast(entity.TypedProperty(STANDARD_TYPE(IGESBasic_Name)));
  return name.IsNull() || name->Value().IsNull() ? std::string() : clean_name(name->Value()->ToCString());
}

// One of the eight colour numbers of IGES 5.3, table 4, or a colour entity with components in percent.
std::string colour_of(const IGESData_IGESEntity& entity) {
  if (const auto own = Handle(IGESGraph_Color)::DownCast(entity.Color()); !own.IsNull()) {
    std::array<double, 3> rgb{};
    own->RGBIntensity(rgb[0], rgb[1], rgb[2]);
    const auto level = [](double percent) {
      return std::isfinite(percent) ? std::lround(255 * std::clamp(percent / 100, 0.0, 1.0)) : 0;
    };
    return fmt::format("{:02x}{:02x}{:02x}", level(rgb[0]), level(rgb[1]), level(rgb[2]));
  }
  constexpr std::array<const char*, 9> known{"",       "000000", "ff0000", "00ff00", "0000ff",
                                             "ffff00", "ff00ff", "00ffff", "ffffff"};
  const int rank = entity.RankColor();
  return 0 <= rank && rank < static_cast<int>(known.size()) ? known[rank] : "";
}

ShapeLabel label_of(const IGESData_IGESEntity& entity) {
  const int level = entity.Level();
  return {name_of(entity), level > 0 ? fmt::format("level_{}", level) : "", colour_of(entity)};
}

using Ends = std::array<gp_Pnt, 2>;

// The ends of a curve entity in space; std::nullopt for other kinds of entities.
std::optional<Ends> ends_of(const Entity& curve) {
  if (const auto line = Handle(IGESGeom_Line)::DownCast(curve); !line.IsNull())
    return Ends{line->TransformedStartPoint(), line->TransformedEndPoint()};
  if (const auto arc = Handle(IGESGeom_CircularArc)::DownCast(curve); !arc.IsNull())
    return Ends{arc->TransformedStartPoint(), arc->TransformedEndPoint()};
  if (const auto spline = Handle(IGESGeom_BSplineCurve)::DownCast(curve); !spline.IsNull() && spline->NbPoles() > 1)
    return Ends{spline->TransformedPole(0), spline->TransformedPole(spline->UpperIndex())};
  return std::nullopt;
}

bool has_ends(const TopoDS_Edge& edge, const Ends& ends, double tolerance) {
  const TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
  if (first.IsNull() || last.IsNull()) return false;
  const gp_Pnt a = BRep_Tool::Pnt(first), b = BRep_Tool::Pnt(last);
  const auto near = [&](const gp_Pnt& p, const gp_Pnt& q) { return p.Distance(q) <= tolerance; };
  return (near(a, ends[0]) && near(b, ends[1])) || (near(a, ends[1]) && near(b, ends[0]));
}

std::vector<Entity> curves_of(const IGESGeom_CurveOnSurface& boundary) {
  const Entity curve = boundary.Curve3D();
  const auto composite = Handle(IGESGeom_CompositeCurve)::DownCast(curve);
  if (composite.IsNull()) return {curve};
  std::vector<Entity> curves;
  for (int i = 1; i <= composite->NbCurves(); ++i) curves.push_back(composite->Curve(i));
  return curves;
}

// The edges of the wire are in the order of the curves. If their number or ends do not match, no labels are added.
void add_boundary(const Handle(IGESGeom_CurveOnSurface) & boundary, const Handle(Transfer_TransientProcess) & process,
                  OccModel& model) {
  if (boundary.IsNull()) return;
  const TopoDS_Shape wire = TransferBRep::ShapeResult(process, boundary);
  if (wire.IsNull()) return;
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer e(wire, TopAbs_EDGE); e.More(); e.Next()) edges.push_back(TopoDS::Edge(e.Current()));
  const std::vector<Entity> curves = curves_of(*boundary);
  if (curves.size() != edges.size()) return;
  for (size_t i = 0; i < edges.size(); ++i) {
    const std::optional<Ends> ends = curves[i].IsNull() ? std::nullopt : ends_of(curves[i]);
    if (ends && has_ends(edges[i], *ends, 10 * model.tolerance))
      model.labels.try_emplace(edges[i].TShape().get(), edges[i], label_of(*curves[i]));
  }
}

}  // namespace

void add_iges_labels(const IGESData_IGESModel& file, const Handle(Transfer_TransientProcess) & process,
                     OccModel& model) {
  for (int i = 1; i <= file.NbEntities(); ++i) {
    const auto surface = Handle(IGESGeom_TrimmedSurface)::DownCast(file.Entity(i));
    if (surface.IsNull()) continue;
    const TopoDS_Shape face = TransferBRep::ShapeResult(process, surface);
    if (!face.IsNull()) model.labels.try_emplace(face.TShape().get(), face, label_of(*surface));
    add_boundary(surface->OuterContour(), process, model);
    for (int k = 1; k <= surface->NbInnerContours(); ++k) add_boundary(surface->InnerContour(k), process, model);
  }
}

}  // namespace quadrille::cad
